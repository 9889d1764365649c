// No text is cut off, on a projector and on a screen of twice the density.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/panels/list.h"
#include "app/scenes/comparisons.h"
#include "app/scenes/presets.h"
#include "app/window/lists.h"
#include "core/experiments/experiment.h"
#include "tests/support/cut_text.h"
#include "tests/support/lanes_window.h"

namespace whorl::app {
namespace {

struct Screen {
    int width, height;
    float scale;
};

void PrintTo(const Screen& screen, std::ostream* out) {
    *out << screen.width << "x" << screen.height << " at scale " << screen.scale;
}

/// The least window, a projector, and the same at twice the density.
constexpr Screen screens[] = {{900, 600, 1}, {1024, 768, 1}, {2048, 1536, 2}};

class Fit : public testing::TestWithParam<Screen> {
  protected:
    /// @param times  as high as the screen: all of a column that scrolls is drawn at once then
    explicit Fit(int times = 1) : ui_(GetParam().width, times * GetParam().height, GetParam().scale) {}

    /// Nothing of the last frame is cut, or shortened but names and what is said beside them.
    static void expect_whole(const std::string& what, const std::vector<std::string>& names = {}) {
        static const std::set<std::string> commands{"Open…", "Record animation…"};
        const DrawnText text;
        EXPECT_GT(text.all().size(), 20u) << what << ": nothing is drawn";
        for (const std::string& line : text.cut()) ADD_FAILURE() << what << ", cut: " << line;
        for (const std::string& line : text.shortened()) {
            const std::string begin = line.substr(0, line.size() - std::string("…").size());
            const bool of_a_name = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                return name.starts_with(begin) || line.starts_with(name);
            });
            if (commands.count(line) == 0 && !of_a_name) ADD_FAILURE() << what << ", shortened: " << line;
        }
    }

    HeadlessUi ui_;
};

class FitTall : public Fit {
  protected:
    FitTall() : Fit(4) {}
};

Recording run_of(const Scene& scene, std::vector<LaneSetup> lanes) {
    Recording run{.setup = {.scene = scene, .lanes = std::move(lanes)}};
    run.setup.scene.resolution = 16;
    return run;
}

Recording with_lanes(std::size_t lanes) {
    return run_of(presets().front().scene(), std::vector<LaneSetup>(lanes));
}

void open_all_panels(LanesWindow& window) {
    window.frame();
    for (const PanelEntry* panel : panels().all()) {
        if (panel->open) continue;
        const ControlRect heading = window.log.rects().in_sight("panel=" + std::string(panel->title)).value();
        window.click({heading.x + 0.5f * heading.width, heading.y + 0.5f * heading.height});
    }
    for (int frame = 0; frame < 3; ++frame) window.frame();
}

/// The names of its lanes, and those of scenes and comparisons, which are shortened to what fits.
std::vector<std::string> names_in(const LanesWindow& window) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < window.names.size(); ++k) names.push_back(window.names.name(k));
    for (const LaneSetup& lane : window.client.setup().lanes) {
        if (!lane.name.empty()) names.push_back(lane.name);
    }
    for (const Experiment& e : experiments()) names.push_back(scene_of(e).title);
    for (const Comparison& comparison : comparisons()) names.push_back(comparison.lanes().title);
    return names;
}

TEST_P(FitTall, ColumnsOfAnyNumberOfLanes) {
    for (const std::size_t lanes : {1u, 2u, 6u}) {
        LanesWindow window(ui_, with_lanes(lanes));
        open_all_panels(window);
        for (const MeasureTab tab :
             {MeasureTab::Plots, MeasureTab::Spectrum, MeasureTab::Budget, MeasureTab::Table}) {
            window.measure_view.tab = tab;
            for (int frame = 0; frame < 3; ++frame) window.frame();
            expect_whole(std::to_string(lanes) + " lanes, tab " + std::to_string(static_cast<int>(tab)),
                         names_in(window));
        }
    }
}

TEST_P(FitTall, ColumnsOfEveryExperiment) {
    for (const Experiment& e : experiments()) {
        Scene scene = scene_of(e);
        set_parameter(scene, "linked=false");
        LanesWindow window(ui_, run_of(scene, std::vector<LaneSetup>(1)));
        open_all_panels(window);
        // Two values side by side, each with its whole name in the help.
        std::vector<std::string> names = names_in(window);
        names.insert(names.end(), {"Semi-Lagrangian", "Clamp interpolation"});
        expect_whole(std::string(e.info.key), names);
    }
}

INSTANTIATE_TEST_SUITE_P(Screens, FitTall, testing::ValuesIn(screens));

TEST_P(Fit, Labs) {
    for (const LabEntry* lab : labs().all()) {
        LanesWindow window(ui_, with_lanes(2));
        window.features.labs.open(lab->key) = true;
        for (int frame = 0; frame < 3; ++frame) window.frame();
        expect_whole(std::string(lab->label), names_in(window));
    }
}

TEST_P(Fit, DialogsAndHelp) {
    LanesWindow window(ui_, with_lanes(1));
    window.features.help.open = true;
    for (int frame = 0; frame < 3; ++frame) window.frame();
    expect_whole("help");
    const auto last = window.log.rects().in_sight("help-tour");
    ASSERT_TRUE(last);
    EXPECT_LE(last->y + last->height, static_cast<float>(GetParam().height)) << "the foot of the help";
    window.features.help.open = false;
    window.files.ask_open = true;
    for (int frame = 0; frame < 3; ++frame) window.frame();
    expect_whole("open dialog", {"scene or run"});
}

TEST_P(Fit, FilmDialog) {
    LanesWindow window(ui_, with_lanes(1));
    window.files.ask_film = true;
    for (int frame = 0; frame < 3; ++frame) window.frame();
    expect_whole("film dialog");
}

INSTANTIATE_TEST_SUITE_P(Screens, Fit, testing::ValuesIn(screens));

/// Lessons, in the room that the window gives them.
class FitLessons : public Fit {};

TEST_P(FitLessons, ListAndEveryStep) {
    LanesWindow window(ui_, with_lanes(1));
    LessonPlayer& lesson_player = window.features.lessons;
    window.features.right_column.lessons = true;
    for (int frame = 0; frame < 3; ++frame) window.frame();
    expect_whole("list of lessons");
    for (const Lesson& lesson : lessons()) {
        lesson_player.begin(lesson);
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            for (int frame = 0; frame < 3; ++frame) window.frame();
            expect_whole(lesson.key + " " + std::to_string(k + 1), names_in(window));
            lesson_player.next();
        }
    }
}

/// All of the inspector, which scrolls, in the column that lessons leave it.
class FitInspector : public FitTall {};

TEST_P(FitInspector, BesideALesson) {
    for (const char* experiment_name : {"translation-1d", "plume"}) {
        for (const char* schemes : {"advector=semi-lagrangian", "advector=maccormack", "advector=bfecc",
                                    "advector=aslam", "interpolation=fritsch-carlson"}) {
            Recording run = run_of(scene_of(experiment(experiment_name)), std::vector<LaneSetup>(1));
            set_parameter(run.setup.scene, schemes);
            run.step = 20;
            LanesWindow window(ui_, run);
            window.features.right_column.lessons = window.inspector.open = true;
            window.inspector.pick({11.3, 1.25});
            ASSERT_TRUE(window.eventually([&] { return window.client.snapshot().explanation.has_value(); }));
            for (int frame = 0; frame < 3; ++frame) window.frame();
            expect_whole(std::string(experiment_name) + " " + schemes, names_in(window));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Screens, FitInspector, testing::ValuesIn(screens));
INSTANTIATE_TEST_SUITE_P(Screens, FitLessons, testing::ValuesIn(screens));

}  // namespace
}  // namespace whorl::app
