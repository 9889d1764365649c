// Zoom, pan and wipe: what a hand does to how lanes are seen.
#include "app/tools/view_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

using Kind = InputEvent::Kind;

struct Viewed {
    FieldViewports place{.tiles = {{0, {100, 100, 400, 400}, {100, 100, 400, 400}, 40, 40},
                                   {1, {520, 100, 400, 400}, {520, 100, 400, 400}, 40, 40}},
                         .cells = {128, 128}};
    ViewSettings view;
    ViewTool tool{view};
    double x = 0, y = 0;  ///< of the pointer

    bool event(InputEvent event) {
        const bool taken = tool.take(event, place);
        place.window = view.window;
        return taken;
    }
    bool event(Kind kind, double to_x, double to_y, int code = 0, int mods = 0) {
        x = to_x;
        y = to_y;
        return event({.kind = kind, .x = x, .y = y, .code = code, .mods = mods});
    }
    bool type(int character) { return event({.kind = Kind::Character, .x = x, .y = y, .code = character}); }
    bool wheel(double turn, int mods = 0) {
        return event({.kind = Kind::Wheel, .x = x, .y = y, .turn = turn, .mods = mods});
    }
};

TEST(ViewTool, ControlWheelZoomsAboutThePointer) {
    Viewed v;
    EXPECT_FALSE(v.event(Kind::Move, 620, 200));
    EXPECT_FALSE(v.wheel(1)) << "that is the brush's";
    const WorldPoint before = v.place.world(v.place.tiles[1], 620, 200);
    EXPECT_TRUE(v.wheel(3, GLFW_MOD_CONTROL));
    EXPECT_FALSE(v.view.window.whole());
    for (const FieldTile& tile : v.place.tiles) {
        const WorldPoint after = v.place.world(tile, tile.rect.x + 100, 200);
        EXPECT_NEAR(after.x, before.x, 1e-4) << "linked, and held under the pointer";
        EXPECT_NEAR(after.y, before.y, 1e-4);
    }
    EXPECT_TRUE(v.type('-'));
    EXPECT_TRUE(v.type('+'));
    EXPECT_TRUE(v.type('0'));
    EXPECT_TRUE(v.view.window.whole());
    EXPECT_FALSE(v.type('1'));
}

TEST(ViewTool, MiddleOrAltDragMovesWhatIsShown) {
    for (const auto& [button, mods] :
         {std::pair{GLFW_MOUSE_BUTTON_MIDDLE, 0}, {GLFW_MOUSE_BUTTON_LEFT, GLFW_MOD_ALT}}) {
        Viewed v;
        v.event(Kind::Move, 300, 300);
        v.wheel(4, GLFW_MOD_CONTROL);
        const WorldPoint held = v.place.world(v.place.tiles[0], 300, 300);
        EXPECT_TRUE(v.event(Kind::Press, 300, 300, button, mods));
        EXPECT_TRUE(v.event(Kind::Move, 330, 280));
        EXPECT_TRUE(v.event(Kind::Move, 340, 270));
        const WorldPoint now = v.place.world(v.place.tiles[0], 340, 270);
        EXPECT_NEAR(now.x, held.x, 1e-4) << "what was taken hold of stays under the pointer";
        EXPECT_NEAR(now.y, held.y, 1e-4);
        EXPECT_TRUE(v.event(Kind::Release, 340, 270, button));
        EXPECT_FALSE(v.event(Kind::Move, 400, 270));
    }
}

TEST(ViewTool, DragsTheLineBetweenTwoLanesAndNothingElse) {
    Viewed v;
    v.place.tiles.pop_back();
    EXPECT_FALSE(v.event(Kind::Press, 300, 300, GLFW_MOUSE_BUTTON_LEFT)) << "there is no line";
    v.place.wipe = 300.0f;
    EXPECT_FALSE(v.event(Kind::Press, 320, 300, GLFW_MOUSE_BUTTON_LEFT)) << "beside it the brush paints";
    EXPECT_TRUE(v.event(Kind::Press, 303, 300, GLFW_MOUSE_BUTTON_LEFT));
    EXPECT_TRUE(v.event(Kind::Move, 200, 300));
    EXPECT_FLOAT_EQ(v.view.wipe, 0.25f);
    EXPECT_TRUE(v.event(Kind::Move, 900, 300));
    EXPECT_FLOAT_EQ(v.view.wipe, 1.0f);
    EXPECT_TRUE(v.event(Kind::Release, 900, 300, GLFW_MOUSE_BUTTON_LEFT));
}

}  // namespace
}  // namespace whorl::app
