// All panels for all scenes, drawn without a display.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "app/panels/control_column.h"
#include "app/panels/field_area.h"
#include "app/panels/help_overlay.h"
#include "app/panels/measure_column.h"
#include "app/scenes/presets.h"
#include "core/experiments/experiment.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {
namespace {

std::string drawn(HeadlessUi& ui, const Scene& scene, bool help) {
    const std::string path = testing::TempDir() + "panels-" + std::to_string(::getpid()) + ".trace";
    {
        Player player({.setup = {.scene = scene}}, 1);
        player.step_once();
        Notices notices;
        notices.warn("a notice");
        Remote remote(player, notices);
        ViewState view;
        view.help = help;
        History history;
        FrameLog frames;
        frames.add(16.7, 5);
        LaneFields fields;
        LaneNames names;
        HoverHelp hover;
        Trace trace(path);
        Slabs slabs;
        for (int frame = 0; frame < 3; ++frame) {
            remote.begin_frame();
            std::vector<StepMeasures> measures;
            const bool new_run = player.take_measures(measures);
            history.take(measures, 0, new_run);
            fields.update(remote.session(), *view.shown, view.difference);
            names.update(remote.session().setup);
            PanelContext context{ui.theme, remote, view, history, frames, fields, names, hover, trace, slabs};
            ui.frame([&] {
                draw_control_column(context);
                draw_measure_column(context);
                ImGui::SetCursorPos({0, 0});
                draw_field_area(context);
                draw_help_overlay(context);
                hover.end_frame();
            });
        }
    }
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    std::remove(path.c_str());
    return text.str();
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
