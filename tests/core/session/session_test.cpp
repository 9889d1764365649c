// Lanes in lock-step on the same commands; runs that can be replayed, gone back in, and told apart.
#include "core/session/session.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/base/error.h"
#include "core/experiments/experiment.h"
#include "core/io/run_file.h"
#include "core/scene/digest.h"
#include "core/scene/parameters.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"

namespace whorl {
namespace {

Scene plume(std::initializer_list<const char*> settings = {}) {
    Scene scene = scene_of(experiment("plume"));
    set_parameter(scene, "resolution=24");
    for (const char* setting : settings) set_parameter(scene, setting);
    return scene;
}

LaneSetup lane(std::initializer_list<SetParameter> overrides, std::string name = {}) {
    return {.name = std::move(name), .overrides = overrides};
}

void go(Session& session, int steps) {
    for (int k = 0; k < steps; ++k) session.step();
}

std::uint64_t digest_of(const Session& session, std::size_t k) {
    Digest digest;
    digest.add(session.lane(k).simulation().state(), 0);
    return digest.value();
}

const SmokeStroke stroke{.along = {5, 5, 30, 22},
                         .radius = 3,
                         .amounts = {{field::density, 1}, {field::temperature, 60}},
                         .push = 1,
                         .velocity_x = 20,
                         .velocity_y = 5};
const ObstacleStroke wall{.along = {8, 20, 30, 26}, .radius = 1.5};

TEST(Session, LanesOfTheSameParametersStayTheSameBits) {
    Pool pool(2);
    whorl::Setup setup{plume({"advector=aslam", "pressure=ldlt"}),
                       {LaneSetup{}, lane({{"zeta", "2"}}), LaneSetup{}}};
    Session session({.setup = setup}, pool);
    go(session, 10);
    session.apply(stroke);
    session.apply(wall);
    // Two more, one of them while the walls have changed and no projection has seen them yet.
    session.apply(Arrange{{LaneSetup{}, lane({{"zeta", "2"}}), LaneSetup{}, LaneSetup{}}, {0, 1, 2, 1}});
    go(session, 12);
    session.apply(Arrange{std::vector<LaneSetup>(5), {3, 2, 1, 0, 0}});
    go(session, 25);
    for (std::size_t k = 1; k < 5; ++k) EXPECT_EQ(digest_of(session, k), digest_of(session, 0)) << k;
}

TEST(Session, ALaneIsTheSimulationOfItsScene) {
    Pool pool(1);
    Session session({.setup = {plume(), {LaneSetup{}, lane({{"advector", "maccormack"}, {"dt", "0.01"}})}}},
                    pool);
    Simulation alone(plume({"advector=maccormack", "dt=0.01"}), pool);
    go(session, 12);
    while (alone.state().step < session.lane(1).simulation().state().step) alone.step();
    Digest digest;
    digest.add(alone.state(), 0);
    EXPECT_EQ(digest_of(session, 1), digest.value());
    EXPECT_EQ(session.lane(1).simulation().state().step, 20) << "12 steps of 1/60 are 20 of 0.01";
}

TEST(Session, LanesShareTheTimeWhateverTheirSteps) {
    Pool pool(1);
    whorl::Setup setup{
        plume(), {LaneSetup{}, lane({{"dt", "0.05"}}), lane({{"dt", "0.0037"}}), LaneSetup{.refine = 4}}};
    Session session({.setup = setup}, pool);
    for (int k = 0; k < 30; ++k) {
        session.step();
        for (std::size_t i = 0; i < session.lane_count(); ++i) {
            const Simulation& s = session.lane(i).simulation();
            EXPECT_LE(std::abs(s.state().time - session.time()), 0.5000001 * s.scene().dt) << i;
        }
    }
    EXPECT_EQ(session.lane(3).simulation().state().step, 120);
    EXPECT_EQ(session.lane(3).simulation().state().grid().nx, 96);
    session.apply(SetParameter{"dt", "0.02"});
    go(session, 10);
    EXPECT_NEAR(session.lane(3).simulation().state().time, session.time(), 1e-9);
}

TEST(Session, OverridesStayWhenTheSceneChanges) {
    Pool pool(1);
    Session session({.setup = {plume(), {LaneSetup{}, lane({{"zeta", "3"}})}}}, pool);
    session.apply(SetParameter{"zeta", "1"});
    EXPECT_EQ(session.lane(0).simulation().scene().scalars.zeta, 1);
    EXPECT_EQ(session.lane(1).simulation().scene().scalars.zeta, 3);
    session.apply(SetParameter{"advector", "aslam"});
    EXPECT_THROW(session.apply(SetParameter{"interpolation", "bicubic"}), InputError);
    EXPECT_EQ(session.lane(0).simulation().scene().scalars.interpolation.key(), "linear");
    EXPECT_EQ(session.recording().commands.size(), 2u) << "what was refused is not recorded";
}

TEST(Session, ACommandIsRefusedForAllLanesOrNone) {
    Pool pool(1);
    Session session({.setup = {plume(), {LaneSetup{}, lane({{"interpolation", "bicubic"}}, "cubic")}}}, pool);
    try {
        session.apply(SetParameter{"advector", "aslam"});
        FAIL();
    } catch (const InputError& e) {
        EXPECT_TRUE(std::string(e.what()).starts_with("lane \"cubic\": aslam takes")) << e.what();
    }
    EXPECT_EQ(session.lane(0).simulation().scene().scalars.advector.key(), "semi-lagrangian");
    EXPECT_THROW(session.apply(Arrange{{}, {}}), InputError);
    EXPECT_THROW(session.apply(Arrange{std::vector<LaneSetup>(7), std::vector<int>(7)}), InputError);
    EXPECT_THROW(session.apply(Arrange{{LaneSetup{}}, {2}}), InputError);
    EXPECT_THROW(session.apply(Arrange{{LaneSetup{.refine = 3}}, {0}}), InputError);
    EXPECT_EQ(session.lane_count(), 2u);
}

/// A run in which a person does a bit of everything.
void use(Session& session) {
    go(session, 7);
    session.apply(stroke);
    go(session, 9);
    session.apply(SetParameter{"advector", "maccormack"});
    session.apply(wall);
    go(session, 3);
    session.apply(
        Arrange{{LaneSetup{}, lane({{"zeta", "1"}, {"advector", "aslam"}}), lane({{"resolution", "33"}})},
                {0, 0, 1},
                1});
    go(session, 20);
    session.apply(ObstacleStroke{.along = {8, 20, 12, 22}, .radius = 2, .solid = false});
    session.apply(SetParameter{"resolution", "30"});
    go(session, 18);
}

whorl::Setup two_lanes() {
    return {plume({"pressure=ldlt", "confinement=1"}),
            {LaneSetup{}, lane({{"interpolation", "fritsch-carlson"}})}};
}

TEST(Session, AReplayGivesTheSameBitsWithAnyThreads) {
    Pool one(1), two(2);
    Session session({.setup = two_lanes()}, two);
    use(session);
    const Recording recording = session.recording();
    EXPECT_EQ(recording.step, 57);
    const Recording read = parse_run(write_run(recording), "text");
    EXPECT_EQ(read, recording) << write_run(recording);
    for (Pool* pool : {&one, &two}) {
        Session replay(read, *pool);
        while (replay.step_number() < recording.step) replay.step();
        EXPECT_EQ(replay.digest(), session.digest());
    }
}

/// Back and forth in a run, whatever checkpoints have been kept.
RC_GTEST_PROP(Session, ComesBackToTheSameBits, ()) {
    static Pool pool(1);
    const auto limit = *rc::gen::element<std::size_t>(0, 200'000, 2'000'000, Session::checkpoints_limit);
    Session session({.setup = two_lanes()}, pool, limit);
    use(session);
    static const std::vector<std::uint64_t> digests = [] {
        Session once({.setup = two_lanes()}, pool);
        use(once);
        Session replay(once.recording(), pool);
        std::vector<std::uint64_t> all{replay.digest()};
        while (replay.step_number() < once.step_number()) {
            replay.step();
            all.push_back(replay.digest());
        }
        return all;
    }();
    RC_ASSERT(session.digest() == digests.back());
    for (int k = 0; k < 4; ++k) {
        const long to = *rc::gen::inRange<long>(0, 58);
        if (to < session.step_number()) session.rewind(to);
        RC_ASSERT(session.step_number() <= to);
        while (session.step_number() < to) session.step();
        RC_ASSERT(session.digest() == digests[static_cast<std::size_t>(to)]);
        RC_ASSERT(session.last_step() == 57);
    }
}

TEST(Session, HandsOverAllOfItselfWhereverItStands) {
    Pool pool(1);
    Session session({.setup = two_lanes()}, pool);
    use(session);
    const Recording all = session.recording();
    EXPECT_EQ(session.whole_recording(), all);
    session.rewind(12);
    EXPECT_LT(session.recording().commands.size(), all.commands.size());
    EXPECT_EQ(session.whole_recording(), all);
}

TEST(Session, WhoActsInThePastTakesAnotherWay) {
    Pool pool(1);
    Session session({.setup = two_lanes()}, pool);
    use(session);
    session.rewind(12);
    while (session.step_number() < 12) session.step();
    session.apply(SetParameter{"beta", "1"});
    EXPECT_EQ(session.last_step(), 12);
    go(session, 30);
    EXPECT_EQ(session.recording().commands.size(), 2u) << "the stroke at 7 and the new edit";
    Session replay(session.recording(), pool);
    go(replay, 42);
    EXPECT_EQ(replay.digest(), session.digest());
}

TEST(Session, RestartBeginsARecordingOfWhatIsSet) {
    Pool pool(1);
    Session session({.setup = two_lanes()}, pool);
    use(session);
    session.apply(Restart{});
    EXPECT_EQ(session.step_number(), 0);
    EXPECT_EQ(session.last_step(), 0);
    EXPECT_EQ(session.lane_count(), 3u);
    EXPECT_TRUE(session.recording().commands.empty());
    go(session, 15);
    Session fresh({.setup = session.setup()}, pool);
    go(fresh, 15);
    EXPECT_EQ(fresh.digest(), session.digest());
}

TEST(Session, KeepsWithinItsMemory) {
    Pool pool(1);
    CheckpointStore kept(1'000'000);
    Session session({.setup = two_lanes()}, pool);
    session.step();
    for (long step = 10; step <= 2000; step += 10) {
        SessionCheckpoint checkpoint;
        checkpoint.lanes.push_back(session.lane(0).checkpoint());
        if (kept.wants(step)) kept.keep(step, std::move(checkpoint));
        ASSERT_LE(kept.bytes(), 1'000'000u);
    }
    EXPECT_GT(kept.bytes(), 250'000u) << "it uses what it has";
    EXPECT_GT(kept.before(2000).first, 1000);
    EXPECT_EQ(kept.before(5).second, nullptr);
}

TEST(Session, AFineLaneIsTheTruthWhereNoneIsKnown) {
    Pool pool(1);
    Session session({.setup = {plume(), {LaneSetup{}, LaneSetup{.refine = 4}, LaneSetup{}}, 1}}, pool);
    go(session, 40);
    EXPECT_TRUE(std::isnan(session.measures(1).errors.L1)) << "it is not measured against itself";
    EXPECT_EQ(session.measures(0).errors.L2, session.measures(2).errors.L2);
    // By hand: the mean of 4 × 4 cells.
    const Field& fine = session.lane(1).simulation().state().density();
    const Field& coarse = session.lane(0).simulation().state().density();
    double sum = 0;
    for (int j = 0; j < coarse.height(); ++j) {
        for (int i = 0; i < coarse.width(); ++i) {
            double mean = 0;
            for (int k = 0; k < 16; ++k) mean += static_cast<double>(fine(4 * i + k % 4, 4 * j + k / 4)) / 16;
            sum += std::abs(static_cast<double>(coarse(i, j)) - mean);
        }
    }
    sum *= session.lane(0).simulation().state().grid().cell();
    EXPECT_NEAR(session.measures(0).errors.L1 / sum, 1, 1e-5) << "single precision, summed in another order";
    // An exact solution is a better truth.
    const Scene known = scene_of(experiment("translation"));
    Session exact({.setup = {known, {LaneSetup{}, LaneSetup{.refine = 2}}, 1}}, pool);
    do exact.step();
    while (exact.step_number() < known.steps && std::isnan(exact.lane(0).simulation().measures().errors.L1));
    ASSERT_TRUE(std::isfinite(exact.lane(0).simulation().measures().errors.L1));
    EXPECT_EQ(exact.measures(0).errors.L1, exact.lane(0).simulation().measures().errors.L1);
}

TEST(Session, OtherLanesGoOnWhenOneStops) {
    Pool pool(1);
    Session session({.setup = {plume(), {LaneSetup{}, LaneSetup{}}}}, pool);
    session.apply(Arrange{{LaneSetup{}, lane({{"alpha", "1000"},
                                              {"beta", "-1000"},
                                              {"advector", "bfecc"},
                                              {"limiter", "none"},
                                              {"dt", "100"}})},
                          {0, 1}});
    go(session, 400);
    EXPECT_FALSE(session.lane(0).failure());
    EXPECT_TRUE(session.running());
    EXPECT_EQ(session.step_number(), 400);
}

TEST(Lanes, TitlesSayWhatDiffers) {
    const auto of = [](std::vector<LaneSetup> lanes) { return titles({plume(), std::move(lanes)}); };
    EXPECT_EQ(of({lane({{"zeta", "1"}}), lane({{"zeta", "2"}, {"dt", "0.01"}})}),
              (std::vector<std::string>{"Δt = 0.01667 · ζ = 1", "Δt = 0.01 · ζ = 2"}));
    EXPECT_EQ(of({LaneSetup{}, lane({{"advector", "aslam"}})}),
              (std::vector<std::string>{"Semi-Lagrangian", "ASLAM"}));
    EXPECT_EQ(of({LaneSetup{}, LaneSetup{.name = "mine"}}), (std::vector<std::string>{"Lane 1", "mine"}));
    EXPECT_EQ(of({LaneSetup{}, lane({{"velocity.advector", "aslam"}})})[1], "velocity: ASLAM");
}

}  // namespace
}  // namespace whorl
