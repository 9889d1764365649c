// What is watched of a run: the sum behind a node, and where limiters acted.
#include <gtest/gtest.h>

#include <cmath>

#include "core/experiments/experiment.h"
#include "core/inspect/explain.h"
#include "core/inspect/limiter_map.h"
#include "core/inspect/text.h"
#include "core/scene/parameters.h"
#include "core/session/player.h"
#include "core/sources/obstacle_stroke.h"
#include "tests/support/eventually.h"

namespace whorl {
namespace {

Recording plume(const char* advector = "maccormack", int resolution = 16) {
    Scene scene = scene_of(experiment("plume"));
    set_parameter(scene, "resolution=" + std::to_string(resolution));
    set_parameter(scene, std::string("advector=") + advector);
    return {.setup = {.scene = scene}, .commands = {}, .step = 0};
}

const Watch::Node node{field::density, {20, 6}};

const std::optional<Explanation>& explanation(Player& player) {
    return player.newest().lanes[0].explanation;
}

TEST(Watch, SnapshotsExplainTheNodeNearestToAPoint) {
    for (const FieldId quantity : {field::density, field::u, field::v}) {
        Pool pool(1);
        Session session(plume(), pool);
        for (int k = 0; k < 10; ++k) session.step();
        SessionSnapshot out;
        take_snapshot(session, out, pool, out);
        EXPECT_FALSE(out.lanes[0].explanation);
        const Grid& grid = out.lanes[0].grid();
        // A little off the node.
        const Field& field = *session.lane(0).simulation().last_advection()->from(quantity);
        WorldPoint at = world(field, grid, 8, 2);
        at = {at.x + 0.4 * grid.h, at.y - 0.4 * grid.h};
        take_snapshot(session, out, pool, out, Watch::Node{quantity, at});
        ASSERT_TRUE(out.lanes[0].explanation);
        const Explanation direct =
            explain(*session.lane(0).simulation().last_advection(), quantity, 8, 2, pool);
        EXPECT_EQ(write_text(*out.lanes[0].explanation), write_text(direct));
        // A point beyond the domain has a nearest node too.
        take_snapshot(session, out, pool, out, Watch::Node{quantity, {1e6, -1e6}});
        EXPECT_EQ(out.lanes[0].explanation->i, field.width() - 1);
        EXPECT_EQ(out.lanes[0].explanation->j, 0);
    }
}

TEST(Watch, FollowsTheRunAndStandsWhilePaused) {
    Player player(plume(), 1);
    player.step_once();
    ASSERT_TRUE(eventually([&] { return player.newest().step == 1; }));
    EXPECT_FALSE(explanation(player));
    player.watch({.node = node, .limiters = false});
    ASSERT_TRUE(eventually([&] { return explanation(player).has_value(); }));
    EXPECT_EQ(player.newest().step, 1) << "paused: the same moment once more";
    player.step_once();
    ASSERT_TRUE(eventually([&] { return player.newest().step == 2; }));
    ASSERT_TRUE(explanation(player));
    EXPECT_EQ(explanation(player)->now, explanation(player)->result);
    player.watch({});
    ASSERT_TRUE(eventually([&] { return !explanation(player).has_value(); }));
    EXPECT_EQ(player.newest().step, 2);
}

TEST(Watch, KnowsTheStepThatLedToAnyMoment) {
    Player player(plume(), 1);
    player.set_pace({.steps_per_frame = 1, .unlimited = true});
    player.play(true);
    ASSERT_TRUE(eventually([&] { return player.newest().step > 25; }));
    // 20 is a moment that is kept whole.
    player.seek(20);
    ASSERT_TRUE(eventually([&] { return player.newest().step == 20 && !player.seek_target(); }));
    const std::uint64_t digest = player.newest().digest();
    player.watch({.node = node, .limiters = true});
    ASSERT_TRUE(eventually([&] { return player.newest().step == 20 && explanation(player).has_value(); }));
    EXPECT_EQ(player.newest().digest(), digest);
    ASSERT_TRUE(player.newest().lanes[0].limits);
    // And while it is watched.
    const std::string at_20 = write_text(*explanation(player));
    player.seek(10);
    ASSERT_TRUE(eventually([&] { return player.newest().step == 10 && !player.seek_target(); }));
    EXPECT_TRUE(explanation(player));
    player.seek(20);
    ASSERT_TRUE(eventually([&] { return player.newest().step == 20 && !player.seek_target(); }));
    EXPECT_EQ(write_text(*explanation(player)), at_20);
    // Nothing led to the start.
    player.seek(0);
    ASSERT_TRUE(eventually([&] { return player.newest().step == 0 && !player.seek_target(); }));
    EXPECT_FALSE(explanation(player));
}

TEST(Watch, AMomentThatWasChangedIsNotTakenAgainForEveryNode) {
    Player player(plume(), 1);
    player.set_pace({.steps_per_frame = 1, .unlimited = true});
    player.play(true);
    ASSERT_TRUE(eventually([&] { return player.newest().step > 12; }));
    player.seek(10);
    ASSERT_TRUE(eventually([&] { return player.newest().step == 10 && !player.seek_target(); }));
    const std::uint64_t before = player.push(ObstacleStroke{.along = {5, 30, 10, 30}, .radius = 2});
    ASSERT_TRUE(eventually([&] { return player.newest().taken == before; }));
    std::vector<StepMeasures> measures;
    player.watch({.node = node, .limiters = false});
    ASSERT_TRUE(
        eventually([&] { return player.newest().lanes[0].watched == node && !player.seek_target(); }));
    EXPECT_FALSE(explanation(player)) << "a wall was built since";
    player.take_measures(measures);
    measures.clear();
    const Watch::Node other{field::density, {10, 10}};
    player.watch({.node = other, .limiters = false});
    ASSERT_TRUE(eventually([&] { return player.newest().lanes[0].watched == other; }));
    player.take_measures(measures);
    EXPECT_TRUE(measures.empty()) << "no step was taken";
    EXPECT_EQ(player.newest().step, 10);
}

TEST(Watch, OtherRunsAndLanesAreWatchedToo) {
    Player player(plume(), 1);
    player.watch({.node = node, .limiters = true});
    Recording other = plume("bfecc", 12);
    other.setup.lanes.resize(2);
    other.step = 5;
    player.load(other);
    ASSERT_TRUE(eventually([&] { return player.newest().step == 5 && player.newest().lanes.size() == 2; }));
    for (const Snapshot& lane : player.newest().lanes) {
        EXPECT_TRUE(lane.explanation);
        EXPECT_TRUE(lane.limits);
    }
    // Another grid has no last step.
    player.push(SetParameter{"resolution", "14"});
    ASSERT_TRUE(eventually([&] { return player.newest().lanes[0].grid().nx == 14; }));
    EXPECT_FALSE(player.newest().lanes[0].limits);
    EXPECT_FALSE(player.newest().lanes[0].explanation);
}

TEST(Watch, LimitersAreCountedAtEveryStep) {
    Pool pool(1);
    Session session(plume(), pool);
    session.step();
    EXPECT_TRUE(std::isnan(session.measures(0).limited.density));
    session.watch_limiters(true);
    EXPECT_FALSE(std::isnan(session.measures(0).limited.density)) << "the last step, at once";
    double most = 0;
    for (int k = 0; k < 30; ++k) {
        session.step();
        const LimiterCounts& counts = session.measures(0).limited;
        const LastAdvection last = *session.lane(0).simulation().last_advection();
        Field density, u, v;
        EXPECT_EQ(counts.density, limiter_map(last, field::density, pool, density));
        EXPECT_EQ(counts.velocity,
                  limiter_map(last, field::u, pool, u) + limiter_map(last, field::v, pool, v));
        const LimiterMasks& marks = *session.limits(0);
        EXPECT_EQ(marks.density(8, 2), density(8, 2));
        EXPECT_EQ(marks.velocity(8, 2), (u(8, 2) + u(9, 2) + v(8, 2) + v(8, 3)) / 4);
        most = std::max(most, counts.velocity);
    }
    EXPECT_GT(most, 0);
    session.watch_limiters(false);
    EXPECT_TRUE(std::isnan(session.measures(0).limited.density));
    EXPECT_EQ(session.limits(0), nullptr);
}

TEST(Watch, WatchingChangesNoBit) {
    Pool pool(1);
    Session plain(plume(), pool), watched(plume(), pool);
    watched.watch_limiters(true);
    SessionSnapshot out;
    for (int k = 0; k < 20; ++k) {
        plain.step();
        watched.step();
        take_snapshot(watched, out, pool, out, node);
    }
    EXPECT_EQ(plain.digest(), watched.digest());
}

TEST(Watch, AGivenFlowIsNotLimited) {
    Scene scene = scene_of(experiment("rotation"));
    set_parameter(scene, "resolution=16");
    set_parameter(scene, "advector=maccormack");
    Pool pool(1);
    Session session({.setup = {.scene = scene}, .commands = {}, .step = 0}, pool);
    session.watch_limiters(true);
    for (int k = 0; k < 5; ++k) session.step();
    EXPECT_TRUE(std::isnan(session.measures(0).limited.velocity));
    EXPECT_GT(session.measures(0).limited.density, 0);
    SessionSnapshot out;
    take_snapshot(session, out, pool, out, Watch::Node{field::u, {1, 1}});
    EXPECT_FALSE(out.lanes[0].explanation);
}

}  // namespace
}  // namespace whorl
