// The slice in the window: how its line is dragged on the fields, and what keeps off it.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>

#include "app/labs/slice.h"
#include "app/labs/slice_overlay.h"
#include "app/labs/slice_tool.h"
#include "app/tools/brush_tool.h"
#include "core/experiments/experiment.h"
#include "tests/support/eventually.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

constexpr double rounding = 1e-12;  // of fractions and cells in double precision

/// The window with its slice open, two lanes of which the second is finer, and the tools that share the
/// mouse.
struct SliceWindow {
    static Recording recording(const char* key) {
        Scene scene = scene_of(experiment(key));
        scene.resolution = 20;
        std::vector<LaneSetup> lanes(2);
        lanes[1].refine = 2;
        return {.setup = {.scene = scene, .lanes = lanes}};
    }

    HeadlessUi ui{1600, 1000, 1};
    LanesWindow window;
    Slice& lab = window.slice;
    SliceTool slice{ui.theme, window.client, lab};
    BrushTool brush{window.client};

    explicit SliceWindow(const char* key = "rotation") : window(ui, recording(key)) {
        lab.open = true;
        for (int k = 0; k < 3; ++k) window.frame();
    }
    void frame() {
        brush.end_frame();
        window.frame();
    }
    /// As the main window shares events out.
    bool event(InputEvent::Kind kind, glm::dvec2 at, int button = 0, int mods = 0) {
        const InputEvent event{.kind = kind, .x = at.x, .y = at.y, .code = button, .mods = mods};
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {static_cast<float>(at.x), static_cast<float>(at.y)};
        if (kind == InputEvent::Kind::Press) io.MouseDown[button] = true;
        if (kind == InputEvent::Kind::Release) io.MouseDown[button] = false;
        const bool taken = slice.take(event, window.place);
        if (!taken) brush.take(event, window.place);
        frame();
        return taken;
    }
    /// @return whether the line took it
    bool drag(glm::dvec2 from, glm::dvec2 to, int mods = 0) {
        event(InputEvent::Kind::Move, from);
        const bool taken = event(InputEvent::Kind::Press, from, 0, mods);
        for (int k = 1; k <= 8; ++k) event(InputEvent::Kind::Move, glm::mix(from, to, k / 8.0));
        event(InputEvent::Kind::Release, to);
        return taken;
    }
    /// A place on a lane's field, in fractions from the lower left corner.
    glm::dvec2 on(std::size_t lane, double x, double y) const {
        const FieldTile& tile = *window.place.of(lane);
        return window.place.pixel(tile, {x * tile.width, y * tile.height});
    }
};

using Kind = InputEvent::Kind;

/// A pixel of the field, in fractions of it; pixels are whole where the tile's place is rounded.
double a_pixel(const SliceWindow& s) {
    return 1.0 / s.window.place.tiles.front().rect.width;
}

TEST(SliceWindow, EndsAreDraggedOnAnyTile) {
    SliceWindow s;
    EXPECT_TRUE(s.drag(s.on(0, 1, 10.5 / 20), s.on(0, 0.6, 0.9)));
    EXPECT_NEAR(s.lab.line.to.x, 0.6, a_pixel(s));
    EXPECT_NEAR(s.lab.line.to.y, 0.9, a_pixel(s));
    EXPECT_EQ(s.lab.line.from, glm::dvec2(0, 10.5 / 20)) << "the other end is where it was drawn";
    EXPECT_TRUE(s.drag(s.on(1, 0, 10.5 / 20), s.on(1, 0.2, 0.7)));
    EXPECT_NEAR(s.lab.line.from.x, 0.2, a_pixel(s));
    EXPECT_NEAR(s.lab.line.from.y, 0.7, a_pixel(s));
    // All of it, by a place between them.
    const SliceLine before = s.lab.line;
    EXPECT_TRUE(s.drag(s.on(0, 0.4, 0.8), s.on(0, 0.5, 0.5)));
    EXPECT_NEAR(s.lab.line.from.x, before.from.x + 0.1, a_pixel(s));
    EXPECT_NEAR(s.lab.line.to.y, before.to.y - 0.3, a_pixel(s));
    EXPECT_EQ(s.lab.held, SliceGrip::None);
}

TEST(SliceWindow, SnapsWithinThreePixelsAndKeepsACell) {
    SliceWindow s;
    s.lab.line = {{0.2, 0.3}, {0.8, 0.7}};
    s.frame();
    s.drag(s.on(0, 0.8, 0.7), s.on(0, 0.7, 0.3) + glm::dvec2(0, 2));
    EXPECT_TRUE(s.lab.line.horizontal());
    s.drag(s.on(0, s.lab.line.to.x, s.lab.line.to.y), s.on(0, 0.7, s.lab.line.to.y) + glm::dvec2(0, 6));
    EXPECT_FALSE(s.lab.line.horizontal());
    s.drag(s.on(0, s.lab.line.to.x, s.lab.line.to.y), s.on(0, s.lab.line.from.x, s.lab.line.from.y));
    EXPECT_NEAR(place_line(s.lab.line, s.window.client.session().lanes[0].grid()).cells(), 1, rounding);
}

TEST(SliceWindow, NoSmokeIsPaintedWhileTheLineIsHeld) {
    SliceWindow s("empty");
    const auto digest = [&] { return s.window.client.session().digest(); };
    const std::uint64_t clear = digest();
    EXPECT_TRUE(s.drag(s.on(0, 1, 10.5 / 20), s.on(0, 0.6, 0.9)));
    EXPECT_TRUE(s.drag(s.on(0, 0.3, 10.5 / 20 + 0.3 / 0.6 * (0.9 - 10.5 / 20)), s.on(0, 0.5, 0.5)));
    EXPECT_TRUE(lastingly([&] {
        s.window.frame();
        return digest() == clear;
    }));
    // Beside it the brush paints, with shift on it the brush builds, and closed it is not there.
    const SliceLine line = s.lab.line;
    EXPECT_FALSE(s.drag(s.on(0, 0.1, 0.1), s.on(0, 0.2, 0.1)));
    EXPECT_TRUE(s.window.eventually([&] { return digest() != clear; }));
    const glm::dvec2 middle = 0.5 * (line.from + line.to);
    EXPECT_FALSE(s.drag(s.on(0, middle.x, middle.y), s.on(0, 0.5, 0.2), GLFW_MOD_SHIFT));
    s.lab.open = false;
    s.frame();
    EXPECT_FALSE(s.drag(s.on(0, middle.x, middle.y), s.on(0, 0.5, 0.2)));
    EXPECT_EQ(s.lab.line, line);
}

TEST(SliceWindow, ThePointerTellsWhatItWouldHoldAndThePlotWhereItIs) {
    SliceWindow s;
    const auto at = [&](glm::dvec2 pixel) {
        s.event(Kind::Move, pixel);
        return std::pair(s.lab.under_pointer, ImGui::GetMouseCursor());
    };
    EXPECT_EQ(at(s.on(0, 1, 10.5 / 20)), std::pair(SliceGrip::To, int{ImGuiMouseCursor_Hand}));
    EXPECT_EQ(at(s.on(1, 0, 10.5 / 20)), std::pair(SliceGrip::From, int{ImGuiMouseCursor_Hand}));
    EXPECT_EQ(at(s.on(0, 0.25, 10.5 / 20)), std::pair(SliceGrip::Whole, int{ImGuiMouseCursor_ResizeAll}));
    ASSERT_TRUE(s.lab.pointed_on_field);
    EXPECT_NEAR(*s.lab.pointed_on_field, 0.25, a_pixel(s));
    EXPECT_EQ(at(s.on(0, 0.25, 0.8)), std::pair(SliceGrip::None, int{ImGuiMouseCursor_Arrow}));
    EXPECT_FALSE(s.lab.pointed_on_field);
}

TEST(SliceWindow, HoldsOnlyWhereTheZoomedFieldShowsIt) {
    SliceWindow s;
    s.window.view.window = {{0.25f, 0.25f}, {0.75f, 0.75f}};
    s.frame();
    EXPECT_TRUE(s.drag(s.on(0, 0.5, 10.5 / 20), s.on(0, 0.5, 0.62)));
    EXPECT_NEAR(s.lab.line.from.y, 12.5 / 20, rounding);
    EXPECT_EQ(s.lab.line.from.x, 0);
    EXPECT_FALSE(s.drag(s.on(0, 1, 12.5 / 20), s.on(0, 0.6, 0.6))) << "that end is not on screen";
}

TEST(SliceWindow, AOneDimensionalRunHasNothingToDrag) {
    SliceWindow s("translation-1d");
    EXPECT_TRUE(s.window.place.tiles.empty());
    const SliceLine line = s.lab.line;
    EXPECT_FALSE(s.drag({500, 500}, {600, 500}));
    EXPECT_EQ(s.lab.line, line);
}

}  // namespace
}  // namespace whorl::app
