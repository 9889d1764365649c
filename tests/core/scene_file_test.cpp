// Scene files: round trip, and errors that name file, line and column.
#include "core/io/scene_file.h"

#include <gtest/gtest.h>

#include "core/experiments/experiment.h"
#include "core/scene/error.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

std::string complaint(const std::string& text) {
    try {
        parse_scene(text, "scene.toml");
    } catch (const InputError& e) {
        return e.what();
    }
    return {};
}

TEST(SceneFile, GivesEverySceneBack) {
    for (const Experiment& e : experiments()) {
        Scene scene = scene_of(e);
        scene.title = "a \"title\" with\nlines and ζ";
        scene.obstacles = {{.x = 3, .y = 4, .radius = 2},
                           {.x = 9, .y = 4, .radius = 0, .width = 2, .height = 1}};
        set_parameter(scene, "velocity.advector=bfecc");
        set_parameter(scene, "dt=0.0123456789");
        const Scene back = parse_scene(write_scene(scene), "written");
        if (scene.dimensions == 2) {
            EXPECT_EQ(back, scene) << write_scene(scene);
        } else {
            EXPECT_EQ(back.dimensions, 1);
        }
    }
}

TEST(SceneFile, KeepsWhatItDoesNotName) {
    const Scene scene = parse_scene(
        "whorl = 1\nexperiment = \"plume\"\nresolution = 64\nscalars.advector = \"aslam\"\n", "s");
    const Scene plume = scene_of(experiment("plume"));
    EXPECT_EQ(scene.resolution, 64);
    EXPECT_EQ(scene.beta, plume.beta);
    EXPECT_EQ(scene.emitters, plume.emitters);
    EXPECT_EQ(scene.scalars.advector, Advectors::of<Aslam>());
    EXPECT_EQ(scene.velocity.advector, Advectors::of<SemiLagrangian>());
}

TEST(SceneFile, ErrorsNameLineAndColumn) {
    EXPECT_EQ(complaint("whorl = 1\nzeta = 9\n"), "scene.toml:2:8: zeta = 9 is out of range: 0 to 4");
    EXPECT_TRUE(
        complaint("whorl = 1\n\n  zetta = 2\n").starts_with("scene.toml:3:3: unknown parameter \"zetta\""));
    EXPECT_TRUE(complaint("whorl = 1\nzeta = \n").starts_with("scene.toml:2:"));
    EXPECT_TRUE(complaint("zeta = 2\n").starts_with("scene.toml:1:1: not a Whorl scene"));
    EXPECT_TRUE(complaint("whorl = 2\n").starts_with("scene.toml:1:9: this is a scene of another version"));
    EXPECT_TRUE(
        complaint("whorl = 1\nexperiment = \"plum\"\n").starts_with("scene.toml:2:14: unknown experiment"));
    EXPECT_TRUE(
        complaint("whorl = 1\n[[emitter]]\nheat = 3\n").starts_with("scene.toml:3:1: unknown key \"heat\""));
    EXPECT_TRUE(complaint("whorl = 1\nemitter = 3\n").starts_with("scene.toml:2:"));
    EXPECT_TRUE(complaint("whorl = 1\n[[obstacle]]\nx = 3\n")
                    .starts_with("scene.toml:2:1: an obstacle has a radius"));
    EXPECT_NE(
        complaint("whorl = 1\nadvector = \"aslam\"\ninterpolation = \"bicubic\"\n").find("linear weights"),
        std::string::npos);
}

TEST(SceneFile, SurvivesHostileText) {
    EXPECT_NE(complaint(std::string(100000, '[')), "");
    EXPECT_NE(complaint("whorl = 1\nx = " + std::string(5000, '[') + std::string(5000, ']')), "");
    EXPECT_NE(complaint(std::string("\xff\xfe\x00whorl", 8)), "");
    EXPECT_NE(complaint("whorl = 1\nresolution = 99999999999999999999\n"), "");
    EXPECT_NE(complaint("whorl = 1\nresolution = nan\n"), "");
}

// What fuzzing, and thinking of it, found.

TEST(SceneFile, RefusesKeysOfManyDots) {
    std::string dots;
    for (int k = 0; k < 100'000; ++k) dots += "a.";
    EXPECT_EQ(complaint("whorl = 1\n" + dots + "a = 1\n"), "scene.toml:2:66: too many dots in a key");
    EXPECT_NE(complaint("[" + dots + "a]\n").find("too many dots"), std::string::npos);
    EXPECT_NE(complaint("x = {" + dots + "a = 1}\n").find("too many dots"), std::string::npos);
    std::string quoted;
    for (int k = 0; k < 100'000; ++k) quoted += "\".\" . ";
    EXPECT_NE(complaint(quoted + "a = 1\n").find("too many dots"), std::string::npos);
    // The deepest that is let through: values nest no deeper than 256.
    std::string deep = "whorl = 1\n", end;
    for (int k = 0; k < 250; ++k) {
        deep += dots.substr(0, 2 * 32) + "a = {";
        end += "}";
    }
    EXPECT_NE(complaint(deep + "b = 1" + end + "\n"), "");
    EXPECT_EQ(complaint("whorl = 1\n# ......... e.g. this .............................................\n"
                        "title = \"One. Two. Three ........................................\"\n"),
              "");
}

TEST(SceneFile, LongWordsTakeNoTime) {
    const std::string word(1 << 19, 'z');  // each letter was compared with each of every key
    for (const std::string& text :
         {word + " = 1\n", "experiment = \"" + word + "\"\n", "advector = \"" + word + "\"\n",
          "[[emitter]]\n" + word + " = 1\n", "zeta = \"" + word + "\"\n"}) {
        const std::string reason = complaint("whorl = 1\n" + text);
        EXPECT_NE(reason, "");
        EXPECT_LT(reason.size(), 500u) << "nor does the message repeat them";
    }
}

TEST(SceneFile, ErrorsAreALine) {
    EXPECT_TRUE(complaint("whorl = 1\n\"a\\nb\\u0001\" = 1\n")
                    .starts_with("scene.toml:2:1: unknown parameter \"a?b?\""));
    EXPECT_EQ(complaint("whorl = 1\nx = f\n").find('\n'), std::string::npos);
    std::string letters;
    while (letters.size() < 2000) letters += "ζ";
    const std::string reason = complaint("whorl = 1\n\"x" + letters + "\" = 1\n");
    EXPECT_TRUE(reason.ends_with("ζ …")) << "cut between letters: " << reason;
}

TEST(SceneFile, RefusesMoreCellsThanARunCanHold) {
    const std::string tall = "whorl = 1\nwidth = 1\nheight = 1000\nresolution = 2048\n";
    EXPECT_EQ(complaint(tall),
              "scene.toml: 2048 × 2048000 cells are more than 8388608; set a lower resolution or height");
    EXPECT_NE(complaint(tall + "[[obstacle]]\nradius = 1\n").find("cells are more than"), std::string::npos);
    EXPECT_EQ(complaint("whorl = 1\nwidth = 40\nheight = 80\nresolution = 2048\n"), "");
}

TEST(SceneFile, RefusesNumbersThatAreNoPlace) {
    for (const char* number : {"1e300", "-1e6", "inf", "100001"}) {
        EXPECT_EQ(complaint(std::string("whorl = 1\n[[emitter]]\nx = ") + number + "\n"),
                  "scene.toml:3:5: x is out of range: -100000 to 100000");
        EXPECT_NE(complaint(std::string("whorl = 1\n[[obstacle]]\nradius = ") + number + "\n"), "");
    }
    EXPECT_EQ(complaint("whorl = 1\n[[emitter]]\nfrom = -inf\nuntil = inf\n"), "");
}

TEST(SceneFile, RefusesEndlessInput) {
    EXPECT_EQ(complaint("whorl = 1\n#" + std::string(1 << 20, 'x')), "scene.toml:1:1: too long: over 1 MiB");
    EXPECT_THROW(read_scene("/dev/zero"), InputError);
    EXPECT_THROW(read_scene("/"), InputError);
    EXPECT_THROW(read_scene("/no such file"), InputError);
    std::string list = "whorl = 1\nemitter = [";
    while (list.size() < 1'000'000) list += "{},";
    EXPECT_EQ(complaint(list + "]\n"), "scene.toml:2:11: too many tables of emitter");
}

}  // namespace
}  // namespace whorl
