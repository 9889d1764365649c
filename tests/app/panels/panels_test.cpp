// All panels for all scenes, drawn without a display.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>

#include "app/panels/list.h"
#include "app/scenes/presets.h"
#include "core/experiments/experiment.h"
#include "tests/support/headless_ui.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

/// What else is on screen.
struct Look {
    bool help = false;
    bool open = false, film = false;  ///< dialogs
};

std::string trace_path() {
    return testing::TempDir() + "panels-" + std::to_string(::getpid()) + ".trace";
}

/// The trace, which is then gone.
std::string taken(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    std::remove(path.c_str());
    return text.str();
}

std::string drawn(HeadlessUi& ui, const Recording& run, Look look) {
    const std::string path = trace_path();
    {
        LanesWindow window(ui, run, path);
        window.player.step_once();
        window.notifications.warn("a notification");
        window.features.help.open = look.help;
        window.files.ask_open = look.open;
        window.files.ask_film = look.film;
        for (int frame = 0; frame < 3; ++frame) window.frame();
    }
    return taken(path);
}

std::string drawn(HeadlessUi& ui, const Scene& scene, bool help) {
    return drawn(ui, Recording{.setup = {.scene = scene}}, Look{.help = help});
}

bool has(const std::string& trace, const std::string& key) {
    return trace.find("\"key\":\"" + key + "\"") != std::string::npos;
}

TEST(Panels, MeasureAnyNumberOfLanesInAnyWindow) {
    struct Size {
        int width, height;
        float scale;
    };
    for (const Size size :
         {Size{1600, 1000, 1}, Size{1024, 768, 1}, Size{900, 600, 1}, Size{1800, 1200, 2}}) {
        HeadlessUi ui(size.width, size.height, size.scale);
        for (const int lanes : {1, 2, 5, 6}) {
            SCOPED_TRACE(std::to_string(lanes) + " lanes at " + std::to_string(size.width));
            Recording run{.setup = {.scene = presets().front().scene()}};
            run.setup.scene.resolution = 16;
            run.setup.lanes = std::vector<LaneSetup>(static_cast<std::size_t>(lanes));
            const auto tab = [&](MeasureTab which) {
                const std::string path = trace_path();
                {
                    LanesWindow window(ui, run, path);
                    window.measure_view.tab = which;
                    for (int frame = 0; frame < 3; ++frame) window.frame();
                }
                return taken(path);
            };
            const std::string plots = tab(MeasureTab::Plots);
            for (const char* key :
                 {"timeline", "open", "save-run", "tab=Table", "plot=Total smoke", "plot=Step time"})
                EXPECT_TRUE(has(plots, key)) << key;
            EXPECT_EQ(has(plots, "legend-lane=1"), lanes > 1);
            EXPECT_EQ(has(plots, "plot=Largest density"), lanes > 1);
            EXPECT_TRUE(has(tab(MeasureTab::Spectrum), "plot=spectrum"));
            const std::string budget = tab(MeasureTab::Budget);
            for (const char* key :
                 {"plot=budget", "plot=Effective viscosity", "budget=Energy", "budget=Enstrophy"})
                EXPECT_TRUE(has(budget, key)) << key;
            const std::string table = tab(MeasureTab::Table);
            for (const char* key : {"Smoke=total, %", "Flow=enstrophy", "Cost=ms a step"})
                EXPECT_TRUE(has(table, key)) << key;
            EXPECT_FALSE(has(table, "Error=L1")) << "there is nothing to compare with";
        }
    }
}

TEST(Panels, AreListedOnce) {
    std::set<std::string> titles;
    for (const PanelEntry* panel : panels().all())
        EXPECT_TRUE(titles.insert(panel->title).second) << panel->title;
}

TEST(Panels, DialogsHaveTheirControls) {
    HeadlessUi ui(900, 600, 1);
    const Recording run{.setup = {.scene = presets().front().scene()}};
    const std::string open = drawn(ui, run, Look{.open = true});
    for (const char* key : {"open-path", "open-do", "open-cancel", "open=plume"})
        EXPECT_TRUE(has(open, key)) << key;
    const std::string film = drawn(ui, run, Look{.film = true});
    for (const char* key :
         {"film=MP4", "film=GIF", "film=PNGs", "film-every", "film-fps", "film-do", "film-close"})
        EXPECT_TRUE(has(film, key)) << key;
}

TEST(Panels, DrawEverySceneAndHaveAControlForEveryParameter) {
    HeadlessUi ui(900, 600, 1.0f);
    for (const Preset& preset : presets()) {
        const std::string trace = drawn(ui, preset.scene(), false);
        for (const Parameter& p : parameters()) {
            if (p.key == "steps" || p.key.find("velocity.") == 0 || p.key.find("scalars.") == 0) continue;
            EXPECT_NE(trace.find("\"key\":\"" + p.key + "\""), std::string::npos) << p.key;
        }
    }
    for (const Experiment& e : experiments()) drawn(ui, scene_of(e), false);
}

TEST(Panels, HaveAPairOfControlsWhereTheSchemesAreNotLinked) {
    HeadlessUi ui(900, 600, 2.0f);
    Scene scene;
    set_parameter(scene, "linked=false");
    const std::string trace = drawn(ui, scene, true);
    for (const Parameter& p : parameters()) {
        if (p.key.find("velocity.") != 0 && p.key.find("scalars.") != 0) continue;
        EXPECT_NE(trace.find("\"key\":\"" + p.key + "\""), std::string::npos) << p.key;
    }
}

}  // namespace
}  // namespace whorl::app
