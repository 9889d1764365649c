// Runs as TOML: round trip, and errors that name file, line and column.
#include "core/io/run_file.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/experiments/experiment.h"
#include "core/scene/parameters.h"

namespace whorl {
namespace {

std::string complaint(const std::string& text) {
    try {
        parse_run(text, "scene.toml");
    } catch (const InputError& e) {
        return e.what();
    }
    return {};
}

TEST(RunFile, GivesEverySceneBack) {
    for (const Experiment& e : experiments()) {
        Scene scene = scene_of(e);
        scene.title = "a \"title\" with\nlines and ζ";
        scene.obstacles = {{.x = 3, .y = 4, .radius = 2},
                           {.x = 9, .y = 4, .radius = 0, .width = 2, .height = 1}};
        set_parameter(scene, "velocity.advector=bfecc");
        set_parameter(scene, "dt=0.0123456789");
        const Scene back = parse_run(write_run({.setup = {.scene = scene}}), "written").setup.scene;
        if (scene.dimensions == 2) {
            EXPECT_EQ(back, scene) << write_run({.setup = {.scene = scene}});
        } else {
            EXPECT_EQ(back.dimensions, 1);
        }
    }
}

TEST(RunFile, KeepsWhatItDoesNotName) {
    const Scene scene =
        parse_run("whorl = 1\nexperiment = \"plume\"\nresolution = 64\nscalars.advector = \"aslam\"\n", "s")
            .setup.scene;
    const Scene plume = scene_of(experiment("plume"));
    EXPECT_EQ(scene.resolution, 64);
    EXPECT_EQ(scene.beta, plume.beta);
    EXPECT_EQ(scene.emitters, plume.emitters);
    EXPECT_EQ(scene.scalars.advector, Id<Advector>("aslam"));
    EXPECT_EQ(scene.velocity.advector, Id<Advector>("semi-lagrangian"));
}

TEST(RunFile, ErrorsNameLineAndColumn) {
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

TEST(RunFile, SurvivesHostileText) {
    EXPECT_NE(complaint(std::string(100000, '[')), "");
    EXPECT_NE(complaint("whorl = 1\nx = " + std::string(5000, '[') + std::string(5000, ']')), "");
    EXPECT_NE(complaint(std::string("\xff\xfe\x00whorl", 8)), "");
    EXPECT_NE(complaint("whorl = 1\nresolution = 99999999999999999999\n"), "");
    EXPECT_NE(complaint("whorl = 1\nresolution = nan\n"), "");
}

// What fuzzing, and thinking of it, found.

TEST(RunFile, RefusesKeysOfManyDots) {
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

TEST(RunFile, LongWordsTakeNoTime) {
    const std::string word(1 << 19, 'z');  // each letter was compared with each of every key
    for (const std::string& text :
         {word + " = 1\n", "experiment = \"" + word + "\"\n", "advector = \"" + word + "\"\n",
          "[[emitter]]\n" + word + " = 1\n", "zeta = \"" + word + "\"\n"}) {
        const std::string reason = complaint("whorl = 1\n" + text);
        EXPECT_NE(reason, "");
        EXPECT_LT(reason.size(), 500u) << "nor does the message repeat them";
    }
}

TEST(RunFile, ErrorsAreALine) {
    EXPECT_TRUE(complaint("whorl = 1\n\"a\\nb\\u0001\" = 1\n")
                    .starts_with("scene.toml:2:1: unknown parameter \"a?b?\""));
    EXPECT_EQ(complaint("whorl = 1\nx = f\n").find('\n'), std::string::npos);
    std::string letters;
    while (letters.size() < 2000) letters += "ζ";
    const std::string reason = complaint("whorl = 1\n\"x" + letters + "\" = 1\n");
    EXPECT_TRUE(reason.ends_with("ζ …")) << "cut between letters: " << reason;
}

TEST(RunFile, RefusesMoreCellsThanARunCanHold) {
    const std::string tall = "whorl = 1\nwidth = 1\nheight = 1000\nresolution = 2048\n";
    EXPECT_EQ(complaint(tall),
              "scene.toml: 2048 × 2048000 cells are more than 8388608; set a lower resolution or height");
    EXPECT_NE(complaint(tall + "[[obstacle]]\nradius = 1\n").find("cells are more than"), std::string::npos);
    EXPECT_EQ(complaint("whorl = 1\nwidth = 40\nheight = 80\nresolution = 2048\n"), "");
}

TEST(RunFile, RefusesNumbersThatAreNoPlace) {
    for (const char* number : {"1e300", "-1e6", "inf", "100001"}) {
        EXPECT_EQ(complaint(std::string("whorl = 1\n[[emitter]]\nx = ") + number + "\n"),
                  "scene.toml:3:5: x is out of range: -100000 to 100000");
        EXPECT_NE(complaint(std::string("whorl = 1\n[[obstacle]]\nradius = ") + number + "\n"), "");
    }
    EXPECT_EQ(complaint("whorl = 1\n[[emitter]]\nfrom = -inf\nuntil = inf\n"), "");
}

TEST(RunFile, RefusesEndlessInput) {
    EXPECT_EQ(complaint("whorl = 1\n#" + std::string(1 << 20, 'x')), "scene.toml:1:1: too long: over 1 MiB");
    EXPECT_THROW(read_run_text("/dev/zero"), InputError);
    EXPECT_THROW(read_run_text("/"), InputError);
    EXPECT_THROW(read_run_text("/no such file"), InputError);
    std::string list = "whorl = 1\nemitter = [";
    while (list.size() < 1'000'000) list += "{},";
    EXPECT_EQ(complaint(list + "]\n"), "scene.toml:2:11: 333327 tables of emitter: there are at most 1000");
}

std::string commands(const std::string& lines) {
    return complaint("whorl = 1\ncommands = \"\"\"\n" + lines + "\"\"\"\n");
}

TEST(RunFile, RefusesCommandsThatAreNone) {
    const std::string at = "scene.toml:2:12: command ";
    EXPECT_EQ(commands("0 set zeta=3\n5 smoke 1 2 3 4 1 0.5 30 1 0 0\n"), "");
    EXPECT_EQ(commands("0 set zeta=9\n"), at + "1: zeta = 9 is out of range: 0 to 4");
    EXPECT_TRUE(commands("5 set zeta=1\n\n6 sett zeta=1\n").starts_with(at + "3: unknown command \"sett\""));
    EXPECT_EQ(commands("5 build 1 2 3 4 1\n4 build 1 2 3 4 1\n"),
              at + "2: step 4 is out of order: 5 to 10000000");
    EXPECT_EQ(commands("5 build 1 2 3 4\n"), at + "1: a number is missing");
    EXPECT_EQ(commands("5 build 1 2 nan 4 1\n"), at + "1: \"nan\" is not finite");
    EXPECT_EQ(commands("5 build 1 2 3 4 1e9\n"), at + "1: brush.radius = 1e+09 is out of range: 0.1 to 100");
    EXPECT_EQ(commands("5 build 1 2 3 4 1 5\n"), at + "1: \"5\" is too much");
    EXPECT_EQ(commands("99999999999 build 1 2 3 4 1\n"),
              at + "1: step 99999999999 is out of order: 0 to 10000000");
    EXPECT_EQ(commands("5 lanes 0\n"), at + "1: there is no [[arrangement]] 0 among 0");
    EXPECT_NE(complaint("whorl = 1\nstep = -1\n"), "");
    EXPECT_NE(complaint("whorl = 1\nreference = 3\n"), "");
    EXPECT_NE(complaint("whorl = 1\ndigest = \"x\"\n"), "");
    EXPECT_NE(complaint("whorl = 1\n" +
                        [] {
                            std::string lanes;
                            for (int k = 0; k < 7; ++k) lanes += "[[lane]]\n";
                            return lanes;
                        }()),
              "");
}

TEST(RunFile, RefusesMoreCommandsThanARunHas) {
    std::string many;
    for (std::size_t k = 0; k <= Recording::max_commands; ++k) many += "1 build 1 2 3 4 1\n";
    EXPECT_EQ(commands(many), "scene.toml:2:12: command 100001: there are at most 100000 commands in a run");
    EXPECT_EQ(commands(std::string(17 << 20, '\n')), "scene.toml:1:1: too long for a run: over 16 MiB");
}

TEST(RunFile, ErrorsBehindCommandsKeepTheirLine) {
    EXPECT_TRUE(complaint("whorl = 1\ncommands = \"\"\"\n1 set zeta=1\n2 set zeta=2\n\"\"\"\nzetta = 1\n")
                    .starts_with("scene.toml:6:1: unknown parameter \"zetta\""));
}

}  // namespace
}  // namespace whorl
