#include "app/tools/brush_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <functional>

#include "app/run/session_client.h"
#include "tests/support/eventually.h"

namespace whorl::app {
namespace {

using Kind = InputEvent::Kind;

/// A paused run in an empty box of 40 × 40, 400 × 400 pixels on screen.
struct Painted {
    static Scene empty() {
        Scene scene;
        scene.resolution = 40;
        return scene;
    }

    Player player{{.setup = {.scene = empty()}}, 1};
    Notifications notifications;
    SessionClient client{player, notifications};
    BrushTool brush{client};
    FieldViewports field{.tiles = {{0, {100, 50, 400, 400}, {100, 50, 400, 400}, 40, 40}}};

    Painted() { client.begin_frame(); }
    void event(Kind kind, double x, double y, int button = 0, int mods = 0) {
        brush.take({.kind = kind, .x = x, .y = y, .code = button, .mods = mods}, field);
    }
    /// Waits until the paused run has taken what was sent.
    bool eventually(const std::function<bool(const Snapshot&)>& is_so) {
        return whorl::eventually([&] {
            client.begin_frame();
            return is_so(client.snapshot());
        });
    }
};

TEST(BrushTool, AQuickStrokeLeavesAContinuousTrail) {
    Painted p;
    p.event(Kind::Press, 150, 250);
    p.event(Kind::Move, 300, 250);
    p.event(Kind::Move, 450, 250);
    p.event(Kind::Release, 450, 250);
    p.brush.end_frame();
    ASSERT_TRUE(p.eventually([](const Snapshot& s) { return s.density()(34, 20) > 0.1f; }));
    for (int i = 5; i <= 34; ++i) EXPECT_GT(p.client.snapshot().density()(i, 20), 0.3f) << "at cell " << i;
    EXPECT_GT(p.client.snapshot().state.velocity.u(20, 20), 1.0f) << "the fluid is dragged along";
    EXPECT_LE(p.client.snapshot().state.velocity.u(20, 20), 40.0f) << "but not as fast as the hand";
}

TEST(BrushTool, TheRightButtonOnlyPushes) {
    Painted p;
    p.event(Kind::Press, 200, 250, GLFW_MOUSE_BUTTON_RIGHT);
    p.event(Kind::Move, 300, 250);
    p.brush.end_frame();
    ASSERT_TRUE(p.eventually([](const Snapshot& s) { return s.state.velocity.u(15, 20) > 1.0f; }));
    EXPECT_EQ(p.client.snapshot().density()(15, 20), 0.0f);
}

TEST(BrushTool, ShiftPaintsObstaclesAndControlErasesThem) {
    Painted p;
    const auto solid = [](const Snapshot& s) { return s.solids()[20 * 40 + 20] != 0; };
    p.event(Kind::Press, 305, 245, GLFW_MOUSE_BUTTON_LEFT, GLFW_MOD_SHIFT);
    p.event(Kind::Release, 305, 245);
    p.brush.end_frame();
    ASSERT_TRUE(p.eventually(solid));
    p.event(Kind::Press, 305, 245, GLFW_MOUSE_BUTTON_LEFT, GLFW_MOD_CONTROL);
    p.brush.end_frame();
    EXPECT_TRUE(p.eventually([&](const Snapshot& s) { return !solid(s); }));
}

TEST(BrushTool, IgnoresWhatIsNotOnTheField) {
    Painted p;
    p.event(Kind::Press, 50, 250);
    p.event(Kind::Move, 300, 250);
    p.brush.end_frame();
    p.field.covered = true;
    p.event(Kind::Press, 300, 250);
    p.brush.end_frame();
    EXPECT_TRUE(lastingly([&] {
        p.client.begin_frame();
        return p.client.session().serial == 0;
    }));
}

TEST(BrushTool, TheWheelStaysInRange) {
    EXPECT_NEAR(wheel_radius(2, 1), 2.2, 1e-12);
    EXPECT_NEAR(wheel_radius(2, -100), parameter("brush.radius").slider_min, 1e-12);
    EXPECT_NEAR(wheel_radius(2, 100), parameter("brush.radius").slider_max, 1e-12);
}

}  // namespace
}  // namespace whorl::app
