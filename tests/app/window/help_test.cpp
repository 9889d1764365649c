// Every control has help that says what it means.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <map>
#include <set>

#include "app/scenes/comparisons.h"
#include "app/scenes/presets.h"
#include "app/window/lists.h"
#include "core/experiments/experiment.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

/// Rectangles that are no controls, and drawings that tell the values under the pointer instead.
bool is_control(std::string_view key) {
    static constexpr std::string_view others[] = {"field",
                                                  "field=",
                                                  "panel=",
                                                  "lab-window=",
                                                  "tour-card=",
                                                  "plot=",
                                                  "slice-plot",
                                                  "line-from=",
                                                  "line-to=",
                                                  "interpolation-point=",
                                                  "interpolation-region",
                                                  "stencil-particles"};
    for (const std::string_view other : others) {
        if (key == other || (other.back() == '=' && key.starts_with(other))) return false;
    }
    return true;
}

/// A window that writes down which of its controls say what they are for.
struct HeardWindow : LanesWindow {
    HeardWindow(HeadlessUi& headless, Recording recording) : LanesWindow(headless, std::move(recording)) {
        features.ui.tooltip.on_item = [this](std::string_view key, const TooltipText& help) {
            if (!help.text.empty() || !help.warning.empty()) on_item.emplace(key);
        };
    }
    void frames_of(int count) {
        for (int k = 0; k < count; ++k) frame();
    }
    void click(const std::string& key) {
        frames_of(2);
        const auto where = log.rects().in_sight(key);
        ASSERT_TRUE(where) << key;
        LanesWindow::click({where->x + 0.5f * where->width, where->y + 0.5f * where->height});
        frames_of(2);
    }
    void expect_help(const std::string& what) const {
        for (const std::string& key : log.rects().names()) {
            EXPECT_TRUE(on_item.count(key) > 0 || !is_control(key)) << what << ": " << key << " says nothing";
        }
    }

    std::set<std::string, std::less<>> on_item;
};

Recording run_of(const Scene& scene, std::size_t lanes) {
    Recording run{.setup = {.scene = scene, .lanes = std::vector<LaneSetup>(lanes)}};
    run.setup.scene.resolution = 16;
    return run;
}

/// So high that no panel is scrolled out of sight.
class Help : public testing::Test {
  protected:
    HeadlessUi ui_{1024, 2600, 1};
};

TEST_F(Help, IsThereForColumnsTabsAndLists) {
    for (const std::size_t lanes : {1u, 2u, 6u}) {
        HeardWindow window(ui_, run_of(presets().front().scene(), lanes));
        window.click("panel=Picture");
        for (const MeasureTab tab :
             {MeasureTab::Plots, MeasureTab::Spectrum, MeasureTab::Budget, MeasureTab::Table}) {
            window.measure_view.tab = tab;
            window.frames_of(3);
        }
        window.view.window = {{0.25f, 0.25f}, {0.75f, 0.75f}};
        window.frames_of(2);
        // Each list opens over the others, and closes at a click beside it.
        for (const char* list : {"scene", "comparison", "map", "advector", "interpolation", "tracer",
                                 "limiter", "pressure", "reference"}) {
            if (lanes == 1 && list == std::string_view("reference")) continue;
            window.click(list);
            window.LanesWindow::click({500, 2590});
        }
        if (lanes > 1) window.rename_lane(0);
        window.frames_of(3);
        EXPECT_GT(window.on_item.size(), 60u);
        window.expect_help(std::to_string(lanes) + " lanes");
    }
}

TEST_F(Help, IsThereInEveryExperiment) {
    for (const Experiment& e : experiments()) {
        Scene scene = scene_of(e);
        set_parameter(scene, "linked=false");
        HeardWindow window(ui_, run_of(scene, 1));
        window.frames_of(4);
        window.expect_help(std::string(e.info.key));
    }
}

TEST_F(Help, IsThereInLabs) {
    for (const LabEntry* lab : labs().all()) {
        HeardWindow window(ui_, run_of(presets().front().scene(), 2));
        window.features.labs.open(lab->key) = true;
        window.frames_of(4);
        window.expect_help(std::string(lab->label));
    }
}

TEST_F(Help, IsThereInDialogsTourAndHelp) {
    HeardWindow window(ui_, run_of(presets().front().scene(), 1));
    window.files.ask_open = true;
    window.frames_of(3);
    window.files.escape = true;
    window.frame();
    window.files.escape = false;
    window.files.ask_film = true;
    window.frames_of(3);
    window.files.escape = true;
    window.frame();
    window.files.escape = false;
    window.files.filming = FilmProgress{"film.mp4", 1};
    window.features.tour.begin();
    while (window.features.tour.running()) {
        window.frames_of(4);
        window.features.tour.next();
    }
    window.features.help.open = true;
    window.frames_of(3);
    for (const char* key : {"open-do", "film-do", "tour-next", "help-tour"})
        EXPECT_TRUE(window.on_item.count(key)) << key << " was not drawn";
    window.expect_help("dialogs");
}

TEST_F(Help, IsThereInLessons) {
    HeardWindow window(ui_, run_of(presets().front().scene(), 1));
    LessonPlayer& lesson_player = window.features.lessons;
    window.features.right_column.lessons = true;
    window.frames_of(3);
    lesson_player.begin(lessons().front());
    window.frames_of(3);
    while (!lesson_player.last()) lesson_player.next();
    window.frames_of(3);
    lesson_player.begin(lessons().back());
    while (!lesson_player.last()) lesson_player.next();
    window.frames_of(3);
    EXPECT_TRUE(window.on_item.count("lesson-next"));
    window.expect_help("lessons");
}

TEST(RowLabel, HasItsControlsHelp) {
    HeadlessUi ui(1280, 2400, 1);
    LanesWindow window(ui, run_of(presets().front().scene(), 1));
    window.frame();
    window.frame();
    const auto control = window.log.rects().in_sight("advector");
    ASSERT_TRUE(control);
    const auto tooltip_at = [&](float x) {
        ImGui::GetIO().MousePos = {x, control->y + 0.5f * control->height};
        for (int k = 0; k < 60; ++k) window.frame();
        const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
        return tooltip != nullptr && tooltip->Active;
    };
    EXPECT_TRUE(tooltip_at(control->x - 20)) << "on the word";
    EXPECT_TRUE(tooltip_at(control->x + 20)) << "on the list";
    EXPECT_FALSE(tooltip_at(window.layout.controls.x + 1)) << "on the panel's edge";
}

}  // namespace
}  // namespace whorl::app
