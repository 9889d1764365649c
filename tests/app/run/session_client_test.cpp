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
    explicit Steered(whorl::Setup setup) : player({.setup = std::move(setup)}, 1) { client.begin_frame(); }

    Player player;
    Notifications notifications;
    SessionClient client{player, notifications};

    void choose(std::string_view key, std::string_view value) {
        client.set(parameter(key), parameter(key).parse(value));
    }
    template <class Condition>
    bool eventually(Condition&& condition) {
        return whorl::eventually([&] {
            client.begin_frame();
            return condition();
        });
    }
    bool changed() {
        return eventually(
            [&] { return client.snapshot().scene == client.scene() && client.session().serial > 0; });
    }
};

TEST(SessionClient, ShowsAChoiceAtOnceAndSendsIt) {
    Steered s;
    s.choose("zeta", "4");
    EXPECT_EQ(s.client.scene().scalars.zeta, 4);
    EXPECT_TRUE(s.changed());
    EXPECT_EQ(s.client.snapshot().scene.velocity.zeta, 4);
}

TEST(SessionClient, AslamTakesLinearInterpolationAlongAndSaysSo) {
    Steered s;
    s.choose("interpolation", "fritsch-carlson");
    s.choose("advector", "aslam");
    EXPECT_EQ(s.client.scene().scalars.interpolation.key(), "linear");
    EXPECT_TRUE(s.changed());
    EXPECT_EQ(s.client.snapshot().scene.scalars.advector.key(), "aslam");
    EXPECT_EQ(s.client.snapshot().scene.scalars.interpolation.key(), "linear");
    ASSERT_EQ(s.notifications.shown().size(), 1u);
    EXPECT_NE(s.notifications.shown()[0].text.find("linear weights"), std::string::npos);
}

TEST(SessionClient, OfOneSetOnlyWhereTheyDiffer) {
    Steered s;
    s.choose("linked", "false");
    s.choose("interpolation", "bicubic");
    s.choose("scalars.advector", "aslam");
    EXPECT_EQ(s.client.scene().scalars.interpolation.key(), "linear");
    EXPECT_EQ(s.client.scene().velocity.interpolation.key(), "bicubic");
    EXPECT_TRUE(s.changed());
}

TEST(SessionClient, AValueOutOfRangeIsANotice) {
    Steered s;
    s.client.set(parameter("dt"), -1);
    EXPECT_EQ(s.notifications.shown().size(), 1u);
    EXPECT_EQ(s.client.scene(), s.client.snapshot().scene);
}

// ---- lanes

whorl::Setup three_lanes() {
    return {.scene = {},
            .lanes = {{.name = "a"}, {.name = "b", .overrides = {{"zeta", "3"}}}, {.name = "c"}}};
}

/// Frames until nothing is pending.
bool settled(Steered& s) {
    return s.eventually(
        [&] { return s.client.setup() == s.client.session().setup && s.client.session().serial > 0; });
}

TEST(SessionClient, SetsOneLaneOrAll) {
    Steered s(three_lanes());
    s.client.select(2);
    s.client.set_lane_only(true);
    s.choose("zeta", "4");
    EXPECT_EQ(s.client.scene().scalars.zeta, 4) << "at once";
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.client.session().lanes[0].scene.scalars.zeta, Scene{}.scalars.zeta);
    EXPECT_EQ(s.client.session().lanes[2].scene.scalars.zeta, 4);
    s.client.set_lane_only(false);
    EXPECT_EQ(s.client.scene().scalars.zeta, Scene{}.scalars.zeta);
    s.choose("zeta", "1");
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.client.session().lanes[0].scene.scalars.zeta, 1);
    EXPECT_EQ(s.client.session().lanes[1].scene.scalars.zeta, 3) << "its own stays";
    EXPECT_EQ(s.client.session().lanes[2].scene.scalars.zeta, 4);
}

TEST(SessionClient, DropsOverridesOfOneLaneOrOfAll) {
    Steered s(three_lanes());
    const Parameter& zeta = parameter("zeta");
    const Parameter& velocity_zeta = parameter("velocity.zeta");
    EXPECT_TRUE(s.client.overridden(zeta, 1));
    EXPECT_TRUE(s.client.overridden(velocity_zeta, 1)) << "one of both sets is one of each";
    EXPECT_FALSE(s.client.overridden(zeta, 0));
    EXPECT_FALSE(s.client.overridden(parameter("weights"), 1));
    s.client.select(0);
    s.client.set_lane_only(true);
    s.client.drop_overrides(zeta);
    EXPECT_TRUE(s.client.overridden(zeta, 1)) << "that is another lane's";
    s.client.set_lane_only(false);
    s.client.drop_overrides(zeta);
    EXPECT_FALSE(s.client.overridden(zeta, 1));
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.client.session().lanes[1].scene, s.client.session().lanes[0].scene);
}

TEST(SessionClient, TheBrushIsTheSameInAllLanes) {
    Steered s(three_lanes());
    s.client.set_lane_only(true);
    s.choose("brush.radius", "3");
    EXPECT_EQ(s.client.scene().brush.radius, 3);
    ASSERT_TRUE(settled(s));
    for (const Snapshot& lane : s.client.session().lanes) EXPECT_EQ(lane.scene.brush.radius, 3);
}

TEST(SessionClient, SelectionStaysWithALaneThatMovesAndGoesToOneThatIsAdded) {
    Steered s(three_lanes());
    s.client.select(1);
    Arrange moved = s.client.arrangement();
    std::swap(moved.lanes[0], moved.lanes[1]);
    std::swap(moved.from[0], moved.from[1]);
    EXPECT_TRUE(s.client.arrange(moved));
    EXPECT_EQ(s.client.selected_in_setup(), 0u) << "at once";
    s.client.set_lane_only(true);
    s.choose("zeta", "4");  // before the lanes have moved
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.client.selected(), 0u);
    EXPECT_EQ(s.client.session().lanes[0].scene.scalars.zeta, 4);
    EXPECT_EQ(s.client.session().setup.lanes[0].name, "b");

    Arrange more = s.client.arrangement();
    more.lanes.push_back({.name = "d"});
    more.from.push_back(0);
    EXPECT_TRUE(s.client.arrange(more, 3));
    EXPECT_EQ(s.client.ids().back(), SessionClient::unknown);
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.client.selected(), 3u);
    EXPECT_EQ(s.client.other(), 0u) << "the one before";

    Arrange fewer = s.client.arrangement();
    fewer.lanes.resize(1);
    fewer.from.resize(1);
    EXPECT_TRUE(s.client.arrange(fewer, 0));
    ASSERT_TRUE(settled(s));
    EXPECT_EQ(s.client.selected(), 0u);
    EXPECT_EQ(s.client.other(), 0u);
    EXPECT_FALSE(s.client.lane_only()) << "one lane is all lanes";
}

TEST(SessionClient, ARestartKeepsTheSelectedLane) {
    Steered s(three_lanes());
    s.client.select(2);
    Arrange moved = s.client.arrangement();
    std::rotate(moved.lanes.begin(), moved.lanes.begin() + 2, moved.lanes.end());
    std::rotate(moved.from.begin(), moved.from.begin() + 2, moved.from.end());
    EXPECT_TRUE(s.client.arrange(moved));
    ASSERT_TRUE(settled(s));
    ASSERT_EQ(s.client.session().setup.lanes[s.client.selected()].name, "c");
    const int run = s.client.session().run;
    s.client.restart();
    ASSERT_TRUE(s.eventually([&] { return s.client.session().run != run; }));
    EXPECT_EQ(s.client.session().setup.lanes[s.client.selected()].name, "c");
}

TEST(SessionClient, AnotherSceneKeepsTheLanesThatAreCompared) {
    Steered s;
    Arrange two = s.client.arrangement();
    two.lanes = {LaneSetup{.name = "a"}, LaneSetup{.name = "b", .overrides = {{"zeta", "3"}}}};
    two.from = {0, 0};
    s.client.arrange(two, 1);
    ASSERT_TRUE(s.eventually([&] { return s.client.session().lanes.size() == 2; }));
    Scene other;
    other.title = "another";
    s.client.load_scene("another", other);
    ASSERT_TRUE(s.eventually([&] { return s.client.setup().scene.title == "another"; }));
    EXPECT_EQ(s.client.setup().lanes, two.lanes);
    EXPECT_EQ(s.client.selected(), 1u) << "the selected one too";
    EXPECT_TRUE(s.notifications.shown().empty());
    // One with which they do not go.
    s.choose("interpolation", "linear");
    Arrange particles = s.client.arrangement();
    particles.lanes[0].set({"advector", "aslam"});
    s.client.arrange(particles);
    Scene cubic;
    cubic.title = "cubic";
    set_parameter(cubic, "interpolation=bicubic");
    s.client.load_scene("cubic", cubic);
    ASSERT_TRUE(s.eventually([&] { return s.client.setup().scene.title == "cubic"; }));
    EXPECT_EQ(s.client.setup().lanes.size(), 1u);
    ASSERT_EQ(s.notifications.shown().size(), 1u);
    EXPECT_NE(s.notifications.shown()[0].text.find("begins with one"), std::string::npos);
}

TEST(SessionClient, LanesThatCannotBeAreANotice) {
    Steered s(three_lanes());
    s.choose("resolution", "512");
    ASSERT_TRUE(settled(s));
    Arrange finer = s.client.arrangement();
    finer.lanes[2].refine = 8;
    EXPECT_FALSE(s.client.arrange(finer));
    ASSERT_EQ(s.notifications.shown().size(), 1u);
    EXPECT_NE(s.notifications.shown()[0].text.find("resolution"), std::string::npos);
    EXPECT_EQ(s.client.setup(), s.client.session().setup);
}

TEST(Applicability, SaysWhyAControlHasNoEffect) {
    Scene scene;
    EXPECT_NE(inactive_reason(parameter("zeta"), scene), "");
    EXPECT_NE(inactive_reason(parameter("base"), scene), "");
    EXPECT_NE(inactive_reason(parameter("axis-order"), scene), "");
    EXPECT_EQ(inactive_reason(parameter("interpolation"), scene), "");
    set_parameter(scene, "advector=aslam");
    EXPECT_EQ(inactive_reason(parameter("zeta"), scene), "");
    EXPECT_NE(inactive_reason(parameter("interpolation"), scene), "");
    set_parameter(scene, "advector=maccormack");
    EXPECT_EQ(inactive_reason(parameter("base"), scene), "");
    EXPECT_EQ(inactive_reason(parameter("limiter"), scene), "");
    EXPECT_EQ(inactive_reason(parameter("beta"), scene), "");
    EXPECT_NE(inactive_reason(parameter("beta"), scene_of(experiment("translation"))), "");
}

}  // namespace
}  // namespace whorl::app
