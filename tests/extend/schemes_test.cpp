// Schemes that the program does not know are listed, chosen, run, and told of, through their lists alone.
#include <gtest/gtest.h>

#include <set>

#include "core/inspect/explain.h"
#include "core/scene/digest.h"
#include "core/scene/parameters.h"
#include "core/session/session.h"
#include "core/session/snapshot.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"
#include "tests/extend/additions.h"
#include "tests/extend/toys.h"

namespace whorl::test {
namespace {

struct Toy {
    const char* parameter;
    const char* key;
    std::vector<std::string> with;  ///< settings under which it matters
};
const Toy toys[] = {{"interpolation", "smoothstep", {"clamped=true"}},
                    {"tracer", "heun", {}},
                    {"limiter", "halfway", {"advector=maccormack"}},
                    {"stencil", "far-ring", {"advector=aslam", "zeta=3"}},
                    {"weights", "cone", {"advector=aslam"}},
                    {"sides", "channel", {}},
                    {"advector", "running-mean", {}},
                    {"advector", "drifting-particles", {}}};

Scene plume(const std::vector<std::string>& settings) {
    Scene scene = scene_of(experiment("plume"));
    set_parameter(scene, "resolution=24");
    for (const std::string& setting : settings) set_parameter(scene, setting);
    return scene;
}

Recording recording_of(const Toy& toy) {
    Scene scene = plume(toy.with);
    set_parameter(scene, toy.parameter, toy.key);
    return {.setup = {scene, {LaneSetup{}}}, .step = 20};
}

std::uint64_t digest_of(const Recording& recording, int threads) {
    Pool pool(threads);
    Session session(recording, pool);
    while (session.step_number() < recording.step) session.step();
    return session.digest();
}

TEST(NewScheme, IsAmongTheChoices) {
    for (const Toy& toy : toys) {
        const std::vector<SchemeInfo>& choices = parameter(toy.parameter).choices;
        EXPECT_EQ(std::ranges::count(choices, toy.key, &SchemeInfo::key), 1) << toy.key;
    }
}

TEST(NewScheme, RunsAndIsWhatRuns) {
    std::set<std::uint64_t> digests;
    for (const Toy& toy : toys) {
        const Recording recording = recording_of(toy);
        Recording without = recording;
        without.setup.scene = plume(toy.with);
        const std::uint64_t digest = digest_of(recording, 1);
        EXPECT_EQ(digest, digest_of(recording, 2)) << toy.key;
        EXPECT_NE(digest, digest_of(without, 1)) << toy.key;
        digests.insert(digest);
    }
    EXPECT_EQ(digests.size(), std::size(toys));
}

TEST(NewScheme, IsExplainedOrSaidNotToBe) {
    for (const Toy& toy : toys) {
        Pool pool(1);
        Simulation simulation(recording_of(toy).setup.scene, pool);
        for (int k = 0; k < 12; ++k) simulation.step();
        const auto last = simulation.last_advection();
        ASSERT_TRUE(last);
        const bool known = std::string_view(toy.parameter) != "advector";
        EXPECT_EQ(unexplained(last->setup.scalars).empty(), known) << toy.key;
        if (!known) {
            EXPECT_THROW(explain(*last, field::density, 12, 2, pool), InputError);
            continue;
        }
        const Explanation e = explain(*last, field::density, 12, 2, pool);
        EXPECT_EQ(e.result, static_cast<double>(simulation.state().density()(12, 2))) << toy.key;
    }
}

// Transports with memory.

const SmokeStroke stroke{.along = {5, 5, 30, 22},
                         .radius = 3,
                         .amounts = {{field::density, 1}, {field::temperature, 60}},
                         .push = 1,
                         .velocity_x = 20,
                         .velocity_y = 5};
const ObstacleStroke wall{.along = {8, 20, 30, 26}, .radius = 1.5};

class Remembering : public testing::TestWithParam<const Advector*> {
  protected:
    Scene scene() const { return plume({"advector=" + std::string(GetParam()->info.key)}); }
    /// Everything that can happen to a memory.
    Recording eventful() const {
        Recording recording{
            .setup = {scene(), {LaneSetup{}, {.name = "MC", .overrides = {{"advector", "maccormack"}}}}},
            .step = 40};
        recording.commands = {{3, stroke},
                              {7, wall},
                              {12, SetParameter{"advector", "aslam"}},
                              {15, SetParameter{"advector", std::string(GetParam()->info.key)}},
                              {19, SetParameter{"resolution", "30"}},
                              {23, SetParameter{"velocity.advector", "semi-lagrangian"}},
                              {26, Arrange{{LaneSetup{}, LaneSetup{}}, {0, 0}, no_reference}},
                              {31, stroke}};
        return recording;
    }
};

TEST_P(Remembering, GoesOnFromACheckpointWithTheSameBits) {
    for (const int threads : {1, 2}) {
        Pool pool(threads);
        Simulation simulation(scene(), pool);
        for (int k = 0; k < 10; ++k) simulation.step();
        const Checkpoint kept = simulation.checkpoint();
        EXPECT_FALSE(kept.advection.empty());
        for (int k = 0; k < 5; ++k) simulation.step();
        const Checkpoint once = simulation.checkpoint();
        simulation.restore(kept);
        for (int k = 0; k < 5; ++k) simulation.step();
        const auto same = [&once](const Simulation& other) {
            return other.checkpoint().advection == once.advection &&
                   other.state().density().memory() == once.state.density().memory();
        };
        EXPECT_TRUE(same(simulation)) << threads;
        // Another simulation, which has never stepped.
        Simulation other(scene(), pool);
        other.restore(kept);
        for (int k = 0; k < 5; ++k) other.step();
        EXPECT_TRUE(same(other)) << threads;
        other.step();
        EXPECT_FALSE(same(other)) << "it has gone on";
    }
}

TEST_P(Remembering, GivesTheSameBitsHoweverItIsReplayed) {
    const Recording recording = eventful();
    const std::uint64_t digest = digest_of(recording, 1);
    EXPECT_EQ(digest_of(recording, 2), digest);
    Pool pool(2);
    Session session(recording, pool);
    while (session.step_number() < recording.step) session.step();
    for (const long back : {38, 30, 25, 20, 14, 11, 5, 0}) {
        session.rewind(back);
        while (session.step_number() < recording.step) session.step();
        EXPECT_EQ(session.digest(), digest) << "gone back to " << back;
    }
    SessionSnapshot snapshot;
    take_snapshot(session, {}, pool, snapshot);
    EXPECT_EQ(snapshot.digest(), digest);
}

/// Fields that are the same bit by bit go on differently if what is remembered differs.
TEST_P(Remembering, IsPartOfTheDigest) {
    Pool pool(1);
    Session session({.setup = {scene(), {LaneSetup{}}}}, pool);
    for (int k = 0; k < 5; ++k) session.step();
    Digest fields;
    fields.add(session.lane(0).simulation().state(), 0);
    EXPECT_NE(session.digest(), fields.value());
}

TEST_P(Remembering, ForgetsOnASwitch) {
    Pool pool(1);
    Simulation simulation(scene(), pool);
    for (int k = 0; k < 5; ++k) simulation.step();
    Scene other = simulation.scene();
    set_parameter(other, "advector=bfecc");
    simulation.set(other);
    EXPECT_TRUE(simulation.checkpoint().advection.empty());
    simulation.set(scene());
    EXPECT_TRUE(simulation.checkpoint().advection.empty()) << "seeded when it steps";
    simulation.step();
    EXPECT_FALSE(simulation.checkpoint().advection.empty());
    simulation.restart();
    EXPECT_TRUE(simulation.checkpoint().advection.empty());
}

INSTANTIATE_TEST_SUITE_P(Toys, Remembering, testing::Values(&running_mean, &drifting_particles),
                         [](const auto& run) { return run.index == 0 ? "mean" : "particles"; });

}  // namespace
}  // namespace whorl::test
