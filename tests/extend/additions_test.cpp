// What is added to the program's lists from here alone is in every place that lists, shows, keeps and
// replays.
#include "tests/extend/additions.h"

#include <gtest/gtest.h>

#include <sstream>

#include "app/cli/verbs.h"
#include "app/scenes/presets.h"
#include "core/inspect/explain.h"
#include "core/io/png.h"
#include "core/io/run_file.h"
#include "core/measure/measure.h"
#include "core/sources/smoke_stroke.h"
#include "tests/support/cut_text.h"
#include "tests/support/headless_ui.h"
#include "tests/support/lanes_window.h"
#include "tests/support/own_directory.h"

namespace whorl::test {
namespace {

using app::HeadlessUi;
using app::LanesWindow;

class Additions : public OwnDirectory {
  protected:
    std::string path(const std::string& name) const { return (directory_ / name).string(); }
    std::string text(const std::string& name) const { return contents(directory_ / name); }
    /// A file of a scene whose emitter gives smoke and dye. @param dye amount
    std::string scene_file(double dye) const {
        put(directory_ / "scene.toml",
            "whorl = 1\nresolution = 24\nbeta = 0.35\n[[emitter]]\nx = 20\ny = 3\n"
            "width = 12\nheight = 4\ndensity = 0.5\ntemperature = 50\ndye = " +
                std::to_string(dye) + "\n");
        return path("scene.toml");
    }
};

SmokeStroke stroke(double amount) {
    return {.along = {4, 4, 8, 6},
            .radius = 3,
            .amounts = {{field::density, 0.5}, {field::temperature, 20}, {dye(), amount}}};
}

Recording small_plume() {
    Recording run{.setup = {.scene = app::presets().front().scene()}};
    run.setup.scene.resolution = 24;
    return run;
}

std::string listed(const std::string& what) {
    testing::internal::CaptureStdout();
    app::run_list({what});
    return testing::internal::GetCapturedStdout();
}

TEST_F(Additions, AreListed) {
    const std::pair<const char*, const char*> all[] = {{"fields", "dye"},
                                                       {"measures", "dye_height"},
                                                       {"measures", "dye_percent"},
                                                       {"views", "dye"},
                                                       {"views", "root-density"},
                                                       {"interpolations", "smoothstep"},
                                                       {"tracers", "heun"},
                                                       {"limiters", "halfway"},
                                                       {"stencils", "far-ring"},
                                                       {"weights", "cone"},
                                                       {"sides", "channel"},
                                                       {"orders", "rough"},
                                                       {"edits", "drop"},
                                                       {"views", "kinetic"},
                                                       {"measures", "energy_by_friction"},
                                                       {"measures", "friction_ms"},
                                                       {"advectors", "running-mean"},
                                                       {"advectors", "drifting-particles"},
                                                       {"parameters", "brush.dye"}};
    for (const auto& [what, key] : all)
        EXPECT_NE(listed(what).find("  " + std::string(key) + " "), std::string::npos) << what << ": " << key;
    EXPECT_NE(listed("").find("running-mean"), std::string::npos);
}

TEST_F(Additions, AreInTheMenusOfTheWindow) {
    HeadlessUi ui(1600, 1600, 1);
    {
        LanesWindow window(ui, small_plume(), path("keys"));
        for (int frame = 0; frame < 3; ++frame) window.frame();
        window.features.labs.open("inspector") = true;
        for (int frame = 0; frame < 3; ++frame) window.frame();
    }
    const std::string keys = text("keys");
    for (const char* key : {"view=dye", "view=root-density", "brush.dye", "plot=Height of the dye",
                            "plot=Total of Dye", "inspector-quantity=dye", "view=kinetic", "drop-dye"})
        EXPECT_NE(keys.find('"' + std::string(key) + '"'), std::string::npos) << key;
}

TEST_F(Additions, AreInTheHelp) {
    HeadlessUi ui(1600, 1200, 1);
    LanesWindow window(ui, small_plume());
    window.features.help.open = true;
    for (int frame = 0; frame < 3; ++frame) window.frame();
    EXPECT_NE(app::DrawnText().all().find("a drop of dye"), std::string::npos);
}

TEST_F(Additions, AreInTables) {
    app::RunArguments run;
    run.scene = scene_file(0.5);
    run.steps = 4;
    run.csv = path("run.csv");
    run.measures = "dye_height,dye_percent";
    run.threads = 1;
    ASSERT_EQ(app::run_scene(run), 0);
    std::istringstream rows(text("run.csv"));
    std::string head, row;
    std::getline(rows, head);
    EXPECT_EQ(head, "step,time,dye_height,dye_percent");
    for (std::string next; std::getline(rows, next);) row = next;
    std::vector<double> values;
    std::istringstream words(row);
    for (std::string word; std::getline(words, word, ',');)
        values.push_back(std::stod(word.empty() ? "nan" : word));
    ASSERT_EQ(values.size(), 4u) << row;
    EXPECT_GT(values[2], 0) << "the emitter's dye, somewhere above the floor";
    EXPECT_NEAR(values[3], 100, 20) << "of what the emitter put in";
}

std::uint64_t digest_of(const Recording& recording, int threads) {
    Pool pool(threads);
    Session session(recording, pool);
    while (session.step_number() < recording.step) session.step();
    return session.digest();
}

/// Written to a file, read again, gone back to, copied for the window: all have the dye.
TEST_F(Additions, AreReplayedAndDigested) {
    Recording run = small_plume();
    run.step = 30;
    run.commands = {{2, stroke(0.5)},
                    {5, SetParameter{"interpolation", "smoothstep"}},
                    {9, SetParameter{"advector", "drifting-particles"}},
                    {12, Edit{drop, {20, 20, 5}}},
                    {14, SetParameter{"order", "rough"}},
                    {20, SetParameter{"resolution", "30"}}};
    const std::uint64_t digest = digest_of(run, 1);
    EXPECT_EQ(digest_of(run, 2), digest);
    const std::string file = write_run(run);
    EXPECT_NE(file.find("dye=0.5"), std::string::npos) << file;
    EXPECT_NE(file.find("12 drop 20 20 5"), std::string::npos) << file;
    const Recording read = parse_run(file, "run.toml");
    EXPECT_EQ(read, run);
    EXPECT_EQ(digest_of(read, 1), digest);
    Recording less = run;
    less.commands[0].command = stroke(0.4);
    EXPECT_NE(digest_of(less, 1), digest) << "dye counts for the digest";

    Pool pool(2);
    Session session(run, pool);
    while (session.step_number() < run.step) session.step();
    session.rewind(15);
    while (session.step_number() < run.step) session.step();
    EXPECT_EQ(session.digest(), digest);
    SessionSnapshot snapshot;
    take_snapshot(session, {}, pool, snapshot);
    EXPECT_EQ(snapshot.digest(), digest);
    double most = 0;
    const Field& field = snapshot.lanes[0].state[dye()];
    for (int i = 0; i < field.width(); ++i) most = std::max(most, static_cast<double>(field(i, 5)));
    EXPECT_GT(most, 0.05);
}

TEST_F(Additions, AreExplained) {
    Recording run = small_plume();
    set_parameter(run.setup.scene, "interpolation=smoothstep");
    set_parameter(run.setup.scene, "clamped=true");
    Pool pool(1);
    Session session(run, pool);
    session.apply(stroke(0.5));
    for (int k = 0; k < 5; ++k) session.step();
    const Simulation& simulation = session.lane(0).simulation();
    const auto last = simulation.last_advection();
    ASSERT_TRUE(last);
    const Explanation e = explain(*last, dye(), 6, 6, pool);
    EXPECT_EQ(e.result, static_cast<double>(simulation.state()[dye()](6, 6)));
    EXPECT_GT(e.result, 0);
}

TEST_F(Additions, AreDrawn) {
    const auto picture = [&](const std::string& view, double dye) {
        app::RunArguments run;
        run.scene = scene_file(dye);
        run.steps = 10;
        run.picture = path(view + ".png");
        run.draw.view = view;
        run.draw.width = 300;
        run.threads = 1;
        EXPECT_EQ(app::run_scene(run), 0);
        return read_png(path(view + ".png"));
    };
    const Image dyed = picture("dye", 0.5), smoke = picture("density", 0.5);
    EXPECT_FALSE(dyed == picture("dye", 0));
    EXPECT_TRUE(smoke == picture("density", 0)) << "dye follows the flow and leaves it alone";
    EXPECT_FALSE(picture("root-density", 0.5) == smoke);
}

/// A phase has its share in the budget, which is the energy that the step took in all.
TEST_F(Additions, ActInAStepAndAreMeasured) {
    Scene scene = small_plume().setup.scene;
    set_parameter(scene, "order=rough");
    Pool pool(1);
    Simulation simulation(scene, pool);
    for (int k = 0; k < 20; ++k) simulation.step();
    const double before = simulation.measures().kinetic_energy;
    simulation.step();
    const Measures& m = simulation.measures();
    const double taken = measures().find("energy_by_friction").of(m);
    EXPECT_LT(taken, 0);
    double sum = 0;
    for (const auto& [key, did] : m.phases) sum += did.energy;
    EXPECT_NEAR(m.kinetic_energy - before, sum, 1e-9 * before);
}

TEST_F(Additions, ActOnInput) {
    HeadlessUi ui(1200, 900, 1);
    LanesWindow window(ui, small_plume());
    window.frame();
    window.features.take({.kind = app::InputEvent::Kind::Character, .code = 'j'});
    const auto dyed = [&] {
        const Snapshot& lane = window.client.snapshot();
        return lane.state[dye()](12, lane.grid().ny / 2) > Real(0.5);
    };
    EXPECT_TRUE(window.eventually(dyed));
}

}  // namespace
}  // namespace whorl::test
