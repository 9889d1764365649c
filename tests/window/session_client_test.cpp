#include "app/run/session_client.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/panels/applicability.h"
#include "core/experiments/experiment.h"
#include "tests/support/eventually.h"

namespace whorl::app {
namespace {

struct Steered {
    explicit Steered(Scene scene = {}) : Steered(whorl::Setup{.scene = std::move(scene)}) {}
    explicit Steered(whorl::Setup setup) : player({.setup = std::move(setup)}, 1) { remote.begin_frame(); }

    Player player;
    Notices notices;
    Remote remote{player, notices};

    void choose(std::string_view key, std::string_view value) {
        remote.set(parameter(key), parameter(key).parse(value));
    }
    template <class Condition>
    bool eventually(Condition&& condition) {
        return whorl::eventually([&] {
            remote.begin_frame();
            return condition();
        });
    }
    bool acted() {
        return eventually(
            [&] { return remote.snapshot().scene == remote.scene() && remote.session().serial > 0; });
    }
};

TEST(Remote, ShowsAChoiceAtOnceAndSendsIt) {
    Steered s;
    s.choose("zeta", "4");
    EXPECT_EQ(s.remote.scene().scalars.zeta, 4);
    EXPECT_TRUE(s.acted());
    EXPECT_EQ(s.remote.snapshot().scene.velocity.zeta, 4);
}

TEST(Remote, AslamTakesLinearInterpolationAlongAndSaysSo) {
    Steered s;
    s.choose("interpolation", "fritsch-carlson");
    s.choose("advector", "aslam");
    EXPECT_EQ(s.remote.scene().scalars.interpolation.key(), "linear");
    EXPECT_TRUE(s.acted());
    EXPECT_EQ(s.remote.snapshot().scene.scalars.advector.key(), "aslam");
    EXPECT_EQ(s.remote.snapshot().scene.scalars.interpolation.key(), "linear");
    ASSERT_EQ(s.notices.shown().size(), 1u);
    EXPECT_NE(s.notices.shown()[0].text.find("linear weights"), std::string::npos);
}

TEST(Remote, OfOneSetOnlyWhereTheyDiffer) {
    Steered s;
    s.choose("linked", "false");
    s.choose("interpolation", "bicubic");
    s.choose("scalars.advector", "aslam");
    EXPECT_EQ(s.remote.scene().scalars.interpolation.key(), "linear");
    EXPECT_EQ(s.remote.scene().velocity.interpolation.key(), "bicubic");
    EXPECT_TRUE(s.acted());
}

TEST(Remote, AValueOutOfRangeIsANotice) {
    Steered s;
    s.remote.set(parameter("dt"), -1);
    EXPECT_EQ(s.notices.shown().size(), 1u);
    EXPECT_EQ(s.remote.scene(), s.remote.snapshot().scene);
}

// ---- lanes

whorl::Setup three_lanes() {
    return {.scene = {},
            .lanes = {{.name = "a"}, {.name = "b", .overrides = {{"zeta", "3"}}}, {.name = "c"}}};
}

/// Frames until nothing is pending.
bool settled(Steered& s) {
    return s.eventually(
        [&] { return s.remote.setup() == s.remote.session().setup && s.remote.session().serial > 0; });
}

TEST(Remote, SetsOneLaneOrAll) {
    Steered s(three_lanes());
    s.remote.select(2);
    s.remote.set_lane_only(true);
    s.choose("zeta", "4");
    EXPECT_EQ(s.remote.scene().scalars.zeta, 4) << "at once";
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.remote.session().lanes[0].scene.scalars.zeta, Scene{}.scalars.zeta);
    EXPECT_EQ(s.remote.session().lanes[2].scene.scalars.zeta, 4);
    s.remote.set_lane_only(false);
    EXPECT_EQ(s.remote.scene().scalars.zeta, Scene{}.scalars.zeta);
    s.choose("zeta", "1");
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.remote.session().lanes[0].scene.scalars.zeta, 1);
    EXPECT_EQ(s.remote.session().lanes[1].scene.scalars.zeta, 3) << "its own stays";
    EXPECT_EQ(s.remote.session().lanes[2].scene.scalars.zeta, 4);
}

TEST(Remote, DropsOverridesOfOneLaneOrOfAll) {
    Steered s(three_lanes());
    const Parameter& zeta = parameter("zeta");
    const Parameter& velocity_zeta = parameter("velocity.zeta");
    EXPECT_TRUE(s.remote.overridden(zeta, 1));
    EXPECT_TRUE(s.remote.overridden(velocity_zeta, 1)) << "one of both sets is one of each";
    EXPECT_FALSE(s.remote.overridden(zeta, 0));
    EXPECT_FALSE(s.remote.overridden(parameter("weights"), 1));
    s.remote.select(0);
    s.remote.set_lane_only(true);
    s.remote.drop_overrides(zeta);
    EXPECT_TRUE(s.remote.overridden(zeta, 1)) << "that is another lane's";
    s.remote.set_lane_only(false);
    s.remote.drop_overrides(zeta);
    EXPECT_FALSE(s.remote.overridden(zeta, 1));
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.remote.session().lanes[1].scene, s.remote.session().lanes[0].scene);
}

TEST(Remote, TheBrushIsTheSameInAllLanes) {
    Steered s(three_lanes());
    s.remote.set_lane_only(true);
    s.choose("brush.radius", "3");
    EXPECT_EQ(s.remote.scene().brush.radius, 3);
    ASSERT_TRUE(settled(s));
    for (const Snapshot& lane : s.remote.session().lanes) EXPECT_EQ(lane.scene.brush.radius, 3);
}

TEST(Remote, SelectionStaysWithALaneThatMovesAndGoesToOneThatIsAdded) {
    Steered s(three_lanes());
    s.remote.select(1);
    Arrange moved = s.remote.arrangement();
    std::swap(moved.lanes[0], moved.lanes[1]);
    std::swap(moved.from[0], moved.from[1]);
    EXPECT_TRUE(s.remote.arrange(moved));
    EXPECT_EQ(s.remote.selected_in_setup(), 0u) << "at once";
    s.remote.set_lane_only(true);
    s.choose("zeta", "4");  // before the lanes have moved
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.remote.selected(), 0u);
    EXPECT_EQ(s.remote.session().lanes[0].scene.scalars.zeta, 4);
    EXPECT_EQ(s.remote.session().setup.lanes[0].name, "b");

    Arrange more = s.remote.arrangement();
    more.lanes.push_back({.name = "d"});
    more.from.push_back(0);
    EXPECT_TRUE(s.remote.arrange(more, 3));
    EXPECT_EQ(s.remote.ids().back(), Remote::unknown);
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.remote.selected(), 3u);
    EXPECT_EQ(s.remote.other(), 0u) << "the one before";

    Arrange fewer = s.remote.arrangement();
    fewer.lanes.resize(1);
    fewer.from.resize(1);
    EXPECT_TRUE(s.remote.arrange(fewer, 0));
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.remote.selected(), 0u);
    EXPECT_EQ(s.remote.other(), 0u);
    EXPECT_FALSE(s.remote.lane_only()) << "one lane is all lanes";
}

TEST(Remote, ARestartKeepsTheSelectedLane) {
    Steered s(three_lanes());
    s.remote.select(2);
    Arrange moved = s.remote.arrangement();
    std::rotate(moved.lanes.begin(), moved.lanes.begin() + 2, moved.lanes.end());
    std::rotate(moved.from.begin(), moved.from.begin() + 2, moved.from.end());
    EXPECT_TRUE(s.remote.arrange(moved));
    ASSERT_TRUE(settled(s));
    ASSERT_EQ(s.remote.session().setup.lanes[s.remote.selected()].name, "c");
    const int run = s.remote.session().run;
    s.remote.restart();
    ASSERT_TRUE(s.eventually([&] { return s.remote.session().run != run; }));
    EXPECT_EQ(s.remote.session().setup.lanes[s.remote.selected()].name, "c");
}

TEST(Remote, AnotherSceneKeepsTheLanesThatAreCompared) {
    Steered s;
    Arrange two = s.remote.arrangement();
    two.lanes = {LaneSetup{.name = "a"}, LaneSetup{.name = "b", .overrides = {{"zeta", "3"}}}};
    two.from = {0, 0};
    s.remote.arrange(two, 1);
    ASSERT_TRUE(s.eventually([&] { return s.remote.session().lanes.size() == 2; }));
    Scene other;
    other.title = "another";
    s.remote.load_scene("another", other);
    ASSERT_TRUE(s.eventually([&] { return s.remote.setup().scene.title == "another"; }));
    EXPECT_EQ(s.remote.setup().lanes, two.lanes);
    EXPECT_EQ(s.remote.selected(), 1u) << "the selected one too";
    EXPECT_TRUE(s.notices.shown().empty());
    // One with which they do not go.
    s.choose("interpolation", "linear");
    Arrange particles = s.remote.arrangement();
    particles.lanes[0].set({"advector", "aslam"});
    s.remote.arrange(particles);
    Scene cubic;
    cubic.title = "cubic";
    set_parameter(cubic, "interpolation=bicubic");
    s.remote.load_scene("cubic", cubic);
    ASSERT_TRUE(s.eventually([&] { return s.remote.setup().scene.title == "cubic"; }));
    EXPECT_EQ(s.remote.setup().lanes.size(), 1u);
    ASSERT_EQ(s.notices.shown().size(), 1u);
    EXPECT_NE(s.notices.shown()[0].text.find("begins with one"), std::string::npos);
}

TEST(Remote, LanesThatCannotBeAreANotice) {
    Steered s(three_lanes());
    s.choose("resolution", "512");
    ASSERT_TRUE(settled(s));
    Arrange finer = s.remote.arrangement();
    finer.lanes[2].refine = 8;
    EXPECT_FALSE(s.remote.arrange(finer));
    ASSERT_EQ(s.notices.shown().size(), 1u);
    EXPECT_NE(s.notices.shown()[0].text.find("resolution"), std::string::npos);
    EXPECT_EQ(s.remote.setup(), s.remote.session().setup);
}

TEST(Applicability, SaysWhyAControlHasNoEffect) {
    Scene scene;
    EXPECT_NE(why_idle(parameter("zeta"), scene), "");
    EXPECT_NE(why_idle(parameter("base"), scene), "");
    EXPECT_NE(why_idle(parameter("axis-order"), scene), "");
    EXPECT_EQ(why_idle(parameter("interpolation"), scene), "");
    set_parameter(scene, "advector=aslam");
    EXPECT_EQ(why_idle(parameter("zeta"), scene), "");
    EXPECT_NE(why_idle(parameter("interpolation"), scene), "");
    set_parameter(scene, "advector=maccormack");
    EXPECT_EQ(why_idle(parameter("base"), scene), "");
    EXPECT_EQ(why_idle(parameter("limiter"), scene), "");
    EXPECT_EQ(why_idle(parameter("beta"), scene), "");
    EXPECT_NE(why_idle(parameter("beta"), scene_of(experiment("translation"))), "");
}

}  // namespace
}  // namespace whorl::app
