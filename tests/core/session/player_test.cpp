// The player steps in the background, and commands act.
#include "core/session/player.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "core/base/error.h"
#include "core/experiments/experiment.h"
#include "core/scene/parameters.h"
#include "core/sources/smoke_stroke.h"
#include "tests/support/eventually.h"

namespace whorl {
namespace {

Recording small_plume() {
    Scene scene = scene_of(experiment("plume"));
    set_parameter(scene, "resolution=24");
    return {.setup = {.scene = scene}};
}

TEST(Player, ShowsTheStartAndWaits) {
    Player player(small_plume(), 1);
    EXPECT_EQ(player.newest().step, 0);
    player.begin_frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(player.newest().step, 0);
}

TEST(Player, StepsOnceAndPauses) {
    Player player(small_plume(), 1);
    player.play(true);
    player.step_once();
    ASSERT_TRUE(eventually([&] { return player.newest().step == 1; }));
    EXPECT_FALSE(player.playing());
    player.begin_frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(player.newest().step, 1);
}

TEST(Player, SetsARunAsideForAnotherOne) {
    Player player(small_plume(), 1);
    player.step_once();
    player.push(SetParameter{"beta", "0.1"});
    ASSERT_TRUE(eventually([&] { return player.newest().step == 1 && player.newest().taken == 1; }));
    Recording other = small_plume();
    other.setup.scene.resolution = 12;
    player.load(other, true);
    player.load(other);  // before the first of them has begun, as a rule: the run is set aside all the same
    std::unique_ptr<StashedRun> before;
    ASSERT_TRUE(eventually([&] { return (before = player.take_stash()) != nullptr; }));
    EXPECT_EQ(before->recording.setup, small_plume().setup);
    EXPECT_EQ(before->recording.commands.size(), 1u);
    EXPECT_EQ(before->recording.step, 1);
    EXPECT_TRUE(before->complete);
    const int run = player.newest().run;
    player.load(small_plume());
    ASSERT_TRUE(eventually([&] { return player.newest().run > run; }));
    EXPECT_EQ(player.take_stash(), nullptr) << "nobody asked";
}

TEST(Player, SeeksALoadedRunsStepFromTheCallOn) {
    Player player(small_plume(), 1);
    Recording far = small_plume();
    far.step = 40;
    for (int round = 0; round < 20; ++round) {
        const int run = player.newest().run;
        player.load(far);
        EXPECT_EQ(player.seek_target().value_or(40), 40) << "on its way, or there already";
        // Nothing is sought any more: the newest snapshot is the one that was.
        ASSERT_TRUE(eventually([&] { return !player.seek_target(); }));
        EXPECT_EQ(player.newest().step, 40);
        EXPECT_GT(player.newest().run, run);
        // A run that takes its place does not go on to its step.
        player.load(far);
        player.load(small_plume());
        ASSERT_TRUE(eventually([&] { return !player.seek_target(); }));
        EXPECT_EQ(player.newest().step, 0);
    }
}

TEST(Player, TakesItsPaceFromTheFrames) {
    Player player(small_plume(), 1);
    player.set_pace({.steps_per_frame = 3, .unlimited = false});
    player.play(true);
    player.begin_frame();
    ASSERT_TRUE(eventually([&] { return player.newest().step == 3; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(player.newest().step, 3);
    player.set_pace({.steps_per_frame = 1, .unlimited = true});
    EXPECT_TRUE(eventually([&] { return player.newest().step > 20; }));
    EXPECT_TRUE(eventually([&] { return player.steps_per_second() > 0; }));
}

TEST(Player, CommandsActWhilePaused) {
    Player player(small_plume(), 1);
    player.push(SmokeStroke{.along = {10, 20, 30, 20}, .radius = 3, .amounts = {{field::density, 1}}});
    EXPECT_TRUE(eventually(
        [&] { return player.newest().step == 0 && player.newest().lanes[0].density()(12, 12) > 0; }));
    player.push(SetParameter{"resolution", "32"});
    EXPECT_TRUE(eventually([&] { return player.newest().lanes[0].grid().nx == 32; }));
    player.push(SetParameter{"zeta", "77"});
    std::string error;
    EXPECT_TRUE(eventually([&] { return !(error = player.take_error()).empty(); }));
    EXPECT_EQ(error, "zeta = 77 is out of range: 0 to 4");
}

TEST(Player, MeasuresEveryStepOnce) {
    Player player(small_plume(), 1);
    std::vector<StepMeasures> all;
    EXPECT_TRUE(player.take_measures(all));
    player.set_pace({.steps_per_frame = 1, .unlimited = true});
    player.play(true);
    ASSERT_TRUE(eventually([&] {
        EXPECT_FALSE(player.take_measures(all));
        return all.size() > 30;
    }));
    for (std::size_t k = 0; k < all.size(); ++k) EXPECT_EQ(all[k].step, static_cast<long>(k));
    player.push(Restart{});
    ASSERT_TRUE(eventually([&] { return player.take_measures(all); }));
    EXPECT_EQ(all.front().step, 0);
}

TEST(Player, LoadsAnotherScene) {
    Player player(small_plume(), 1);
    player.load({.setup = {.scene = scene_of(experiment("rotation"))}});
    EXPECT_TRUE(eventually([&] { return player.newest().lanes[0].scene.experiment == "rotation"; }));
    EXPECT_EQ(player.newest().run, 1);
    Recording bad = small_plume();
    set_parameter(bad.setup.scene, "advector=aslam");
    set_parameter(bad.setup.scene, "interpolation=bridson");
    EXPECT_THROW(player.load(bad), InputError);
}

TEST(Player, KeepsTheLastSoundStateWhenARunFails) {
    Player player(small_plume(), 1);
    player.step_once();
    ASSERT_TRUE(eventually([&] { return player.newest().step == 1; }));
    player.push(SmokeStroke{.along = {20, 20, 20, 20},
                            .radius = 3,
                            .amounts = {{field::density, 1}, {field::temperature, INFINITY}}});
    player.step_once();
    ASSERT_TRUE(eventually([&] { return player.newest().lanes[0].failure.has_value(); }));
    EXPECT_TRUE(std::isfinite(player.newest().lanes[0].density()(12, 12)));
    player.push(Restart{});
    EXPECT_TRUE(eventually([&] { return !player.newest().lanes[0].failure && player.newest().step == 0; }));
}

/// Closing, loading and resetting in the middle of everything.
TEST(Player, EndsAtAnyMoment) {
    for (int k = 0; k < 20; ++k) {
        Player player(small_plume(), 2);
        player.set_pace({.steps_per_frame = 1, .unlimited = true});
        player.play(true);
        if (k % 2) player.load({.setup = {.scene = scene_of(experiment("empty"))}});
        if (k % 3) player.push(Restart{});
        if (k % 5) player.push(SetParameter{"resolution", "48"});
        std::this_thread::sleep_for(std::chrono::milliseconds(k));
    }
}

}  // namespace
}  // namespace whorl
