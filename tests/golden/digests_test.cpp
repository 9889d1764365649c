// Every scheme's bits against a committed table: what moves code must not move numbers.
// Renewed, where numbers change on purpose, by `./dev renew digests`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>

#include "core/experiments/experiment.h"
#include "core/io/run_file.h"
#include "core/scene/parameters.h"
#include "core/session/session.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"

namespace whorl {
namespace {

const char* const table_path = WHORL_TEST_DATA "/golden/digests.csv";

using Settings = std::vector<std::string>;

struct DigestRun {
    std::string name;
    Recording recording;
    long rewind_to = -1;  ///< a step to go back to and on from; −1 for a run that goes straight on
};

/// A small, short run: every phase has acted, and a limiter has had something to do.
Recording recording_of(std::string_view name, const Settings& settings) {
    Scene scene = scene_of(experiment(name));
    set_parameter(scene, scene.dimensions == 1 ? "resolution=40" : "resolution=24");
    for (const std::string& setting : settings) set_parameter(scene, setting);
    return {.setup = {scene, {LaneSetup{}}}, .step = 16};
}

/// The settings under which `key` matters, whether it is of one set of schemes or of both.
Settings context_of(std::string key) {
    const std::size_t dot = key.find('.');
    if (dot != std::string::npos) key = key.substr(dot + 1);
    if (key == "base" || key == "limiter") return {"advector=maccormack"};
    if (key == "stencil" || key == "weights" || key == "zeta") return {"advector=aslam"};
    if (key == "clamped" || key == "axis-order") return {"interpolation=fritsch-carlson"};
    return {};
}

/// One run for each value of each choice, over a solved plume and a given rotation, and what else tells runs
/// apart.
std::vector<DigestRun> make_runs() {
    std::vector<DigestRun> runs;
    const auto add = [&](const std::string& experiment_key, const Settings& settings) {
        std::string name = experiment_key;
        for (const std::string& setting : settings) name += " " + setting;
        runs.push_back({name, recording_of(experiment_key, settings)});
    };
    for (const Parameter& p : parameters()) {
        if (p.kind != Parameter::Kind::Choice) continue;
        for (const SchemeInfo& choice : p.choices) {
            Settings settings = context_of(p.key);
            settings.push_back(p.key + "=" + std::string(choice.key));
            add("plume", settings);
            const bool schemes =
                p.group == Parameter::Group::Schemes || p.group == Parameter::Group::Particles;
            if (schemes && !p.key.starts_with("velocity."))  // which is given there
                add("rotation", settings);
        }
    }
    for (const Experiment& e : experiments()) {
        if (e.info.key == "plume" || e.info.key == "rotation") continue;  // above
        for (const SchemeInfo& advector : parameter("advector").choices)
            add(std::string(e.info.key), {"advector=" + std::string(advector.key)});
    }
    for (const char* advector : {"advector=maccormack", "advector=bfecc"}) {
        for (const SchemeInfo& base : parameter("base").choices)
            add("shear-layer", {advector, "base=" + std::string(base.key)});
        for (const SchemeInfo& interpolation : parameter("interpolation").choices)
            add("plume", {advector, "interpolation=" + std::string(interpolation.key), "clamped=true"});
    }
    for (const char* zeta : {"zeta=0", "zeta=1", "zeta=3", "zeta=4"}) add("plume", {"advector=aslam", zeta});
    for (const SchemeInfo& stencil : parameter("stencil").choices) {
        for (const SchemeInfo& weights : parameter("weights").choices)
            add("shear-layer", {"advector=aslam-bilinear", "stencil=" + std::string(stencil.key),
                                "weights=" + std::string(weights.key), "seed=7"});
    }
    add("plume", {"confinement=0.4", "order=smoke", "alpha=0.2", "tolerance=1e-3", "pressure=multigrid"});

    const SmokeStroke stroke{.along = {5, 5, 30, 22},
                             .radius = 3,
                             .amounts = {{field::density, 1}, {field::temperature, 60}},
                             .push = 1,
                             .velocity_x = 20,
                             .velocity_y = 5};
    const ObstacleStroke wall{.along = {8, 20, 30, 26}, .radius = 1.5};
    const ObstacleStroke opening{.along = {18, 20, 22, 26}, .radius = 2, .solid = false};
    Recording lanes = recording_of("plume", {});
    lanes.setup.lanes = {LaneSetup{},
                         {.name = "A", .overrides = {{"advector", "aslam"}}},
                         {.name = "B", .overrides = {{"advector", "maccormack"}, {"dt", "0.01"}}},
                         {.name = "fine", .refine = 2}};
    lanes.setup.reference = 3;
    lanes.step = 24;
    runs.push_back({"lanes", lanes});
    lanes.commands = {{2, stroke},
                      {4, wall},
                      {6, SetParameter{"advector", "bfecc"}},
                      {8, opening},
                      {10, SetParameter{"resolution", "36"}},
                      {12, Arrange{{lanes.setup.lanes[1], LaneSetup{}, LaneSetup{}}, {1, 0, 2}, 1}},
                      {14, SetParameter{"sides", "periodic"}},
                      {16, stroke},
                      {18, SetParameter{"velocity.advector", "aslam-bilinear"}}};
    runs.push_back({"lanes and commands", lanes});
    runs.push_back({"lanes and commands, gone back in", lanes, 13});
    return runs;
}

std::uint64_t digest_of(const DigestRun& run) {
    Pool pool(2);
    // Written and read on the way, as every run that is kept in a file is.
    Session session(parse_run(write_run(run.recording), run.name), pool);
    while (session.step_number() < run.recording.step) session.step();
    if (run.rewind_to >= 0) {
        session.rewind(run.rewind_to);
        while (session.step_number() < run.recording.step) session.step();
    }
    return session.digest();
}

std::string hexadecimal(std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return text;
}

std::map<std::string, std::string> read_table() {
    std::map<std::string, std::string> table;
    std::ifstream file(table_path);
    for (std::string line; std::getline(file, line);) {
        const std::size_t comma = line.rfind(',');
        table[line.substr(0, comma)] = line.substr(comma + 1);
    }
    return table;
}

class Digests : public testing::TestWithParam<int> {};

/// The runs are dealt out to a few cases, which run side by side.
constexpr int parts = 4;

TEST_P(Digests, AreThoseOfTheTable) {
    if (sizeof(Real) != sizeof(float)) GTEST_SKIP() << "the table is of single precision";
    const auto table = read_table();
    const std::vector<DigestRun> runs = make_runs();
    ASSERT_GE(runs.size(), 60u);
    for (std::size_t k = static_cast<std::size_t>(GetParam()); k < runs.size(); k += parts) {
        const auto row = table.find(runs[k].name);
        ASSERT_NE(row, table.end()) << runs[k].name << " is not in the table: ./dev renew digests adds it";
        EXPECT_EQ(hexadecimal(digest_of(runs[k])), row->second) << runs[k].name;
    }
}

INSTANTIATE_TEST_SUITE_P(Part, Digests, testing::Range(0, parts));

TEST(DigestTable, HoldsNoRunThatIsNoMore) {
    auto table = read_table();
    for (const DigestRun& run : make_runs()) table.erase(run.name);
    table.erase("run");
    for (const auto& [name, digest] : table) ADD_FAILURE() << name << " is not run any more";
}

/// No test: writes the table.
TEST(DigestTable, DISABLED_Renew) {
    std::ofstream file(table_path);
    file << "run,digest\n";
    for (const DigestRun& run : make_runs()) file << run.name << ',' << hexadecimal(digest_of(run)) << '\n';
}

}  // namespace
}  // namespace whorl
