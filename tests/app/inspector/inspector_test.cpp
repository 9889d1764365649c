// The inspector: what is picked, what is shown of it, and that painting stands back.
#include "app/inspector/inspection.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "app/inspector/inspect_tool.h"
#include "app/inspector/overlay.h"
#include "core/experiments/experiment.h"
#include "core/inspect/explain.h"
#include "core/inspect/text.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

using Kind = InputEvent::Kind;

Recording stepped(const char* name, std::vector<LaneSetup> lanes = {LaneSetup{}}) {
    Scene scene = scene_of(experiment(name));
    scene.resolution = 24;
    return {.setup = {.scene = scene, .lanes = std::move(lanes)}, .commands = {}, .step = 5};
}

LaneSetup lane(const char* key, const char* value) {
    LaneSetup lane;
    lane.overrides = {{key, value}};
    return lane;
}

/// A window on a run of a few steps, and the tools that its fields take events with.
struct Inspected {
    HeadlessUi ui;
    LanesWindow window;
    Inspection& inspector = window.inspector;
    InspectTool tool{window.client, window.view, inspector};
    InspectedOverlay overlay{ui.theme, window.client, inspector};

    explicit Inspected(Recording recording, int width = 1280, int height = 800)
        : ui(width, height, 1), window(ui, std::move(recording)) {
        window.eventually([&] { return window.client.session().step == 5; });
    }
    bool event(Kind kind, ImVec2 at, int code = GLFW_MOUSE_BUTTON_LEFT, int mods = 0) {
        return tool.take({.kind = kind,
                          .x = static_cast<double>(at.x),
                          .y = static_cast<double>(at.y),
                          .code = code,
                          .mods = mods},
                         window.place);
    }
    /// The pixel at the centre of a cell of a lane.
    ImVec2 pixel(std::size_t lane, int i, int j) const {
        const FieldTile& tile = window.place.tiles[lane];
        const double h = window.client.session().lanes[lane].grid().h;
        const glm::dvec2 at = window.place.pixel(tile, {(i + 0.5) * h, (j + 0.5) * h});
        return {static_cast<float>(at.x), static_cast<float>(at.y)};
    }
    bool click(std::size_t lane, int i, int j) {
        const ImVec2 at = pixel(lane, i, j);
        const bool taken = event(Kind::Press, at);
        event(Kind::Release, at);
        return taken;
    }
    const Explanation& explained(std::size_t lane) const {
        return *window.client.session().lanes[lane].explanation;
    }
    bool wait_for(std::size_t lane, int i, int j) {
        return window.eventually([&] {
            const auto& e = window.client.session().lanes[lane].explanation;
            return e && e->i == i && e->j == j && e->quantity == inspector.node.quantity;
        });
    }
};

TEST(Inspector, AClickInAnyLaneExplainsThatCellInAllOfThem) {
    Inspected in(stepped("plume", {lane("advector", "maccormack"), lane("advector", "aslam")}));
    EXPECT_FALSE(in.click(1, 12, 3)) << "closed, it leaves the field to the brush";
    in.inspector.open = true;
    in.window.frame();
    EXPECT_TRUE(in.click(1, 12, 3));
    EXPECT_EQ(in.window.client.selected(), 1u);
    ASSERT_TRUE(in.wait_for(1, 12, 3));
    ASSERT_TRUE(in.wait_for(0, 12, 3));
    EXPECT_EQ(in.explained(0).steps.size(), 2u);
    EXPECT_FALSE(in.explained(1).steps[0].particles.empty());
    // As the solver has it.
    Pool pool(1);
    Session session(stepped("plume", {lane("advector", "maccormack"), lane("advector", "aslam")}), pool);
    for (int k = 0; k < 5; ++k) session.step();
    for (const std::size_t k : {0u, 1u}) {
        const Explanation direct =
            explain(*session.lane(k).simulation().last_advection(), field::density, 12, 3, pool);
        EXPECT_EQ(write_text(in.explained(k)), write_text(direct));
        EXPECT_EQ(in.explained(k).now, in.window.client.session().lanes[k].density()(12, 3));
    }
}

TEST(Inspector, FollowsTheRun) {
    Inspected in(stepped("plume"));
    in.inspector.open = true;
    in.window.frame();
    in.click(0, 12, 3);
    ASSERT_TRUE(in.wait_for(0, 12, 3));
    in.window.player.step_once();
    ASSERT_TRUE(in.window.eventually([&] { return in.window.client.session().step == 6; }));
    ASSERT_TRUE(in.window.client.snapshot().explanation);
    EXPECT_EQ(in.explained(0).now, in.window.client.snapshot().density()(12, 3));
    // Closed, it costs nothing more.
    in.inspector.open = false;
    EXPECT_TRUE(in.window.eventually([&] { return !in.window.client.snapshot().explanation; }));
}

TEST(Inspector, ADragPicksAsItGoesAndShiftAndAnArrowGoOn) {
    Inspected in(stepped("plume"));
    in.inspector.open = true;
    in.window.frame();
    EXPECT_TRUE(in.event(Kind::Press, in.pixel(0, 5, 5)));
    EXPECT_TRUE(in.event(Kind::Move, in.pixel(0, 9, 7)));
    EXPECT_TRUE(in.event(Kind::Release, in.pixel(0, 9, 7)));
    EXPECT_FALSE(in.event(Kind::Move, in.pixel(0, 3, 3)));
    ASSERT_TRUE(in.wait_for(0, 9, 7));
    EXPECT_TRUE(in.event(Kind::Key, {}, GLFW_KEY_RIGHT, GLFW_MOD_SHIFT));
    EXPECT_TRUE(in.event(Kind::Key, {}, GLFW_KEY_DOWN, GLFW_MOD_SHIFT));
    EXPECT_FALSE(in.event(Kind::Key, {}, GLFW_KEY_RIGHT)) << "the timeline's";
    ASSERT_TRUE(in.wait_for(0, 10, 6));
    for (int k = 0; k < 40; ++k) in.event(Kind::Key, {}, GLFW_KEY_LEFT, GLFW_MOD_SHIFT);
    EXPECT_TRUE(in.wait_for(0, 0, 6)) << "the domain ends there";
    // Other buttons, and clicks with a key, are the brush's and the view's.
    EXPECT_FALSE(in.event(Kind::Press, in.pixel(0, 5, 5), GLFW_MOUSE_BUTTON_RIGHT));
    EXPECT_FALSE(in.event(Kind::Press, in.pixel(0, 5, 5), GLFW_MOUSE_BUTTON_LEFT, GLFW_MOD_ALT));
}

TEST(Inspector, TheFirstClickGoesCloserToAllThatIsDrawn) {
    Inspected in(stepped("plume"));
    in.inspector.open = true;
    in.window.frame();
    in.click(0, 12, 3);
    ASSERT_TRUE(in.wait_for(0, 12, 3));
    in.window.frame();
    const ViewWindow closer = in.window.view.window;
    EXPECT_FALSE(closer.whole());
    in.window.frame();
    const PixelRect& rect = in.window.place.tiles[0].rect;
    for (const BaseStep& step : in.explained(0).steps) {
        for (const KernelNode& node : step.nodes) {
            const glm::dvec2 at = in.window.place.pixel(in.window.place.tiles[0], node.at);
            EXPECT_GE(at.x, rect.x);
            EXPECT_LE(at.x, rect.x + rect.width);
            EXPECT_GE(at.y, rect.y);
            EXPECT_LE(at.y, rect.y + rect.height);
        }
    }
    // Who has chosen what to see is left alone.
    in.click(0, 13, 3);
    ASSERT_TRUE(in.wait_for(0, 13, 3));
    in.window.frame();
    EXPECT_EQ(in.window.view.window.low, closer.low);
    // The wheel is free while nothing is painted.
    const ImVec2 at = in.pixel(0, 12, 3);
    const InputEvent wheel{
        .kind = Kind::Wheel, .x = static_cast<double>(at.x), .y = static_cast<double>(at.y), .turn = 1};
    EXPECT_TRUE(in.tool.take(wheel, in.window.place));
    EXPECT_LT(in.window.view.window.high.x - in.window.view.window.low.x, closer.high.x - closer.low.x);
    in.inspector.open = false;
    EXPECT_FALSE(in.tool.take(wheel, in.window.place));
}

TEST(Inspector, AClickGoesCloserToItsOwnCellNotToTheOneBefore) {
    Inspected in(stepped("plume"));
    in.inspector.open = true;
    in.window.frame();
    in.click(0, 4, 3);
    ASSERT_TRUE(in.wait_for(0, 4, 3));
    in.window.frame();
    in.window.view.window = {};
    in.window.frame();
    in.click(0, 20, 20);
    in.window.frame();  // may still show the one before
    ASSERT_TRUE(in.wait_for(0, 20, 20));
    in.window.frame();
    in.window.frame();
    const ImVec2 middle = in.pixel(0, 20, 20);
    EXPECT_NE(in.window.place.at(static_cast<double>(middle.x), static_cast<double>(middle.y)), nullptr);
    EXPECT_FALSE(in.window.view.window.whole());
}

TEST(Inspector, SumsBelongToTheStepsThatAreDrawn) {
    Inspected in(stepped("plume", {lane("advector", "bfecc")}));
    in.inspector.open = true;
    in.window.frame();
    in.click(0, 12, 3);
    ASSERT_TRUE(in.wait_for(0, 12, 3));
    const Explanation& e = in.explained(0);
    ASSERT_EQ(e.steps.size(), 3u);
    EXPECT_EQ(sum_of(e, 0).value(), e.correction->forward);
    EXPECT_EQ(sum_of(e, 1).value(), e.correction->back);
    EXPECT_EQ(sum_of(e, 2).value(), e.sum.terms.front().value);
    for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_EQ(sum_of(e, k).terms.size(), e.steps[k].nodes.size());
        for (std::size_t n = 0; n < e.steps[k].nodes.size(); ++n)
            EXPECT_EQ(sum_of(e, k).terms[n].weight, e.steps[k].nodes[n].weight) << "the pointed one is lit";
    }
}

TEST(Inspector, CurvesAreInspectedToo) {
    Inspected in(stepped("translation-1d"));
    in.inspector.open = true;
    in.window.frame();
    EXPECT_TRUE(in.overlay.marks().empty());
    const float middle = in.window.layout.field.x + 0.5f * in.window.layout.field.width;
    in.window.click({middle, in.window.layout.top + 0.5f * in.window.layout.height});
    ASSERT_TRUE(in.inspector.picked);
    ASSERT_TRUE(in.window.eventually([&] { return in.window.client.snapshot().explanation.has_value(); }));
    const int i = in.explained(0).i;
    EXPECT_NEAR(i, 12, 2);
    EXPECT_EQ(in.explained(0).now, in.window.client.snapshot().density()(i, 0));
    // Two samples, where they are read, and the node.
    EXPECT_EQ(in.overlay.marks().size(), 4u);
}

TEST(Inspector, AClickAsksTheLaneWhoseCurveIsNearest) {
    // After some steps the bump of two of them is lower than that of the third.
    Recording recording = stepped(
        "translation-1d", {lane("advector", "semi-lagrangian"), LaneSetup{}, lane("advector", "maccormack")});
    recording.setup.lanes[1] = recording.setup.lanes[0];
    recording.step = 60;
    HeadlessUi ui(1280, 800, 1);
    LanesWindow window(ui, recording);
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step == 60; }));
    Inspection& inspector = window.inspector;
    inspector.open = true;
    window.frame();
    constexpr std::size_t low = 0, high = 2;
    const auto row = [&](std::size_t k) { return window.client.session().lanes[k].density().row(0); };
    const int width = window.client.snapshot().grid().nx;
    const auto peak = std::max_element(row(high), row(high) + width) - row(high);
    ASSERT_GT(row(high)[peak], row(low)[peak] + 0.2f);
    // Which sample is under the pointer is the plot's own business: go along until it is the peak.
    const Layout& at = window.layout;
    float x = at.field.x;
    while (!inspector.picked || std::abs(inspector.node.at.x / window.client.snapshot().grid().h - 0.5 -
                                         static_cast<double>(peak)) > 0.1) {
        x += 4;
        ASSERT_LT(x, at.field.x + at.field.width);
        window.click({x, at.top + 0.3f * at.height});
    }
    // Down from above all curves, the higher one comes first, and then the lower one.
    const auto selected = [&](float down) {
        window.click({x, at.top + down * at.height});
        return window.client.selected();
    };
    EXPECT_EQ(selected(0.15f), high);
    float down = 0.15f;
    while (down < 0.9f && selected(down) == high) down += 0.02f;
    EXPECT_EQ(window.client.selected(), low) << "and not the one that it hides";
    EXPECT_GT(down, 0.2f);
    ASSERT_TRUE(window.eventually([&] {
        const auto& e = window.client.snapshot().explanation;
        return e && e->i == peak;
    }));
    EXPECT_EQ(window.client.snapshot().explanation->now, static_cast<double>(row(low)[peak]));
    // Of curves on top of each other the selected one stays so.
    window.client.select(1);
    window.frame();
    EXPECT_EQ(selected(down), 1u);
}

TEST(Inspector, MakesWayForLessons) {
    Inspected in(stepped("plume"), 1024, 768);
    const auto left = [] { return ImGui::FindWindowByName("Inspector")->Pos.x; };
    in.inspector.open = true;
    for (int k = 0; k < 3; ++k) in.window.frame();
    EXPECT_EQ(left(), in.window.layout.measures.x);
    // Opened later, lessons have that column all the same.
    in.window.features.right_column.lessons = true;
    for (int k = 0; k < 3; ++k) in.window.frame();
    EXPECT_EQ(left(), in.window.layout.controls.x);
    in.window.features.right_column.lessons = false;
    for (int k = 0; k < 3; ++k) in.window.frame();
    EXPECT_EQ(left(), in.window.layout.measures.x);
    // Who has put it elsewhere finds it there.
    ImGui::SetWindowPos("Inspector", {300, 40});
    for (int k = 0; k < 3; ++k) in.window.frame();
    EXPECT_EQ(left(), 300);
}

TEST(Inspector, SaysWhyThereIsNothingToTell) {
    // Nothing has moved: the window is drawn all the same, with a reason.
    Recording fresh = stepped("rotation");
    fresh.step = 0;
    HeadlessUi ui(1280, 800, 1);
    LanesWindow window(ui, fresh);
    window.inspector.open = true;
    window.inspector.pick({12, 12});
    window.frame();
    EXPECT_FALSE(window.client.snapshot().explanation);
    window.player.step_once();
    ASSERT_TRUE(window.eventually([&] { return window.client.snapshot().explanation.has_value(); }));
    // A flow that is given is not moved.
    window.inspector.node.quantity = field::u;
    EXPECT_TRUE(window.eventually([&] { return !window.client.snapshot().explanation; }));
    window.frame();
}

}  // namespace
}  // namespace whorl::app
