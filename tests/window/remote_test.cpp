#include "app/panels/remote.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/panels/applicability.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

struct Steered {
    explicit Steered(Scene scene = {}) : player({.setup = {.scene = std::move(scene)}}, 1) { remote.begin_frame(); }

    Player player;
    Notices notices;
    Remote remote{player, notices};

    void choose(std::string_view key, std::string_view value) {
        remote.set(parameter(key), parameter(key).parse(value));
    }
    bool acted() {
        for (int k = 0; k < 500; ++k) {
            remote.begin_frame();
            if (remote.snapshot().scene == remote.scene() && remote.session().serial > 0) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
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
