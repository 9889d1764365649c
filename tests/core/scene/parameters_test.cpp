// The parameter table: every key sets, reads back and refuses.
#include "core/scene/parameters.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/experiments/experiment.h"

namespace whorl {
namespace {

std::string complaint(const std::function<void()>& act) {
    try {
        act();
    } catch (const InputError& e) {
        return e.what();
    }
    return {};
}

TEST(Parameters, HaveKeysLabelsAndHelp) {
    for (const Parameter& p : parameters()) {
        EXPECT_FALSE(p.key.empty());
        EXPECT_FALSE(p.label.empty()) << p.key;
        EXPECT_FALSE(p.help.empty()) << p.key;
        EXPECT_LE(p.min, p.slider_min) << p.key;
        EXPECT_LE(p.slider_max, p.max) << p.key;
        EXPECT_NO_THROW(p.check(p.default_value())) << p.key;
        EXPECT_EQ(&parameter(p.key), &p) << "keys are unique";
    }
}

TEST(Parameters, SetAndReadBackEveryValidEnd) {
    for (const Parameter& p : parameters()) {
        for (const double value : {p.min, p.max, p.default_value()}) {
            Scene scene;
            set_parameter(scene, p.key, p.text(value));
            EXPECT_DOUBLE_EQ(p.get(scene), value) << p.key;
        }
    }
}

TEST(Parameters, ChoicesTakeEveryKey) {
    for (const Parameter& p : parameters()) {
        for (const SchemeInfo& choice : p.choices) {
            Scene scene;
            set_parameter(scene, p.key, choice.key);
            EXPECT_EQ(p.text(p.get(scene)), choice.key);
        }
    }
}

TEST(Parameters, OneChoiceSetsBothAndAPrefixOne) {
    Scene scene;
    set_parameter(scene, "advector=aslam");
    EXPECT_EQ(scene.velocity.advector, Id<Advector>("aslam"));
    EXPECT_EQ(scene.scalars.advector, Id<Advector>("aslam"));
    EXPECT_TRUE(scene.linked);
    set_parameter(scene, "velocity.advector=bfecc");
    EXPECT_EQ(scene.velocity.advector, Id<Advector>("bfecc"));
    EXPECT_EQ(scene.scalars.advector, Id<Advector>("aslam"));
    EXPECT_FALSE(scene.linked);
    set_parameter(scene, "linked=true");
    EXPECT_EQ(scene.velocity, scene.scalars);
}

TEST(Parameters, ComplaintsNameWhatIsRight) {
    Scene scene;
    EXPECT_EQ(complaint([&] { set_parameter(scene, "zeta=9"); }), "zeta = 9 is out of range: 0 to 4");
    EXPECT_EQ(complaint([&] { set_parameter(scene, "zeta=1.5"); }), "zeta = 1.5 is not a whole number");
    EXPECT_EQ(complaint([&] { set_parameter(scene, "dt=fast"); }),
              "dt = \"fast\" is not a number: give one from 1e-06 to 100");
    EXPECT_EQ(complaint([&] { set_parameter(scene, "dt=nan"); }), "dt = nan is out of range: 1e-06 to 100");
    EXPECT_NE(complaint([&] { set_parameter(scene, "advectr=aslam"); }).find("did you mean advector"),
              std::string::npos);
    EXPECT_NE(complaint([&] { set_parameter(scene, "advector=mac"); }).find("did you mean maccormack"),
              std::string::npos);
    EXPECT_EQ(complaint([&] { set_parameter(scene, "clamped=maybe"); }),
              "clamped = maybe is neither true nor false");
    EXPECT_EQ(complaint([&] { set_parameter(scene, "zeta"); }), "\"zeta\" is not of the form key=value");
    EXPECT_EQ(scene, Scene{}) << "a refused value changes nothing";
}

TEST(Scene, RefusesChoicesThatDoNotGoTogether) {
    const auto reason = [](std::initializer_list<const char*> settings) {
        Scene scene;
        for (const char* setting : settings) set_parameter(scene, setting);
        return conflict(scene);
    };
    EXPECT_NE(reason({"advector=aslam", "interpolation=b-spline"}).find("linear weights"), std::string::npos);
    EXPECT_NE(
        reason({"advector=maccormack", "base=aslam", "interpolation=fritsch-carlson"}).find("linear weights"),
        std::string::npos);
    EXPECT_EQ(reason({"advector=maccormack", "interpolation=b-spline"}), "");
    EXPECT_EQ(reason({"advector=semi-lagrangian", "base=aslam", "interpolation=bicubic"}), "")
        << "a base that is not in use";
    EXPECT_EQ(reason({"advector=aslam", "stencil=subsampling", "zeta=0"}), "") << "plain semi-Lagrangian";
    Scene walled = scene_of(experiment("plume"));
    set_parameter(walled, "pressure=diagonalization");
    EXPECT_EQ(conflict(walled), "");
    walled.obstacles = {{.x = 20, .y = 20, .radius = 4}};
    EXPECT_NE(conflict(walled).find("diagonalization is not offered here"), std::string::npos)
        << conflict(walled);
    EXPECT_NE(reason({"scalars.advector=aslam-0", "scalars.interpolation=bridson"}).find("for the scalars"),
              std::string::npos);
}

}  // namespace
}  // namespace whorl
