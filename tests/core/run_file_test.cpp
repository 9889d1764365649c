// Runs as TOML: round trip, and errors that name file, line and column.
#include "core/io/run_file.h"

#include <gtest/gtest.h>

#include "core/experiments/experiment.h"
#include "core/scene/error.h"
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
    EXPECT_EQ(scene.scalars.advector, Advectors::of<Aslam>());
    EXPECT_EQ(scene.velocity.advector, Advectors::of<SemiLagrangian>());
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

}  // namespace
}  // namespace whorl
