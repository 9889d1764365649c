// `whorl lesson`: listed, printed, checked, drawn, and refused where something is wrong.
#include "core/io/png.h"
#include "tests/support/command_line.h"

namespace whorl {
namespace {

constexpr const char* small = R"(whorl = 1
title = "Small"
summary = "A lesson for a test."

[[step]]
title = "Two lanes"
text = '''
# Look
A text.

    q = 1
- an item
'''
try = ["something"]
scene = "rest"
set = ["resolution=16"]
run_to = 3
[[step.lane]]
name = "plain"
[[step.lane]]
name = "affine"
set = ["advector=aslam", "interpolation=linear"]
[[step.claim]]
measure = "L1"
lane = "plain"
at_most = 0
[[step.claim]]
measure = "L1"
lane = "affine"
at_most = 0
)";

TEST_F(CommandLine, ListsAndPrintsLessons) {
    const Outcome list = whorl("lesson");
    EXPECT_EQ(list.code, 0) << list.out;
    EXPECT_NE(list.out.find("Why ASLAM squares the annulus"), std::string::npos) << list.out;
    write("small.toml", small);
    const Outcome text = whorl("lesson small.toml");
    EXPECT_EQ(text.code, 0);
    EXPECT_EQ(text.out,
              "Small\nA lesson for a test.\n\n\n1. Two lanes\n\nLook\n\nA text.\n\n    q = 1\n  - an item\n\n"
              "What to try\n  - something\n");
}

TEST_F(CommandLine, ChecksWhatALessonClaims) {
    write("small.toml", small);
    const Outcome o = whorl("lesson small.toml --check");
    EXPECT_EQ(o.code, 1);
    EXPECT_NE(o.out.find("ok     small.toml:23:1: step 1: L1 of plain at step 3 = 0  (at most 0)\n"),
              std::string::npos)
        << o.out;
    EXPECT_NE(o.out.find("WRONG  small.toml:27:1: step 1: L1 of affine at step 3 = "), std::string::npos)
        << o.out;
    EXPECT_NE(o.out.find("1 of 2 claims hold\n"), std::string::npos) << o.out;
}

TEST_F(CommandLine, DrawsALessonsSteps) {
    write("small.toml", small);
    const Outcome o = whorl("lesson small.toml --pictures .");
    EXPECT_EQ(o.code, 0) << o.out;
    EXPECT_GT(read_png(folder / "small-1.png").width, 100);
    // The picture carries the step's run.
    EXPECT_EQ(whorl("run small-1.png").code, 0);
}

TEST_F(CommandLine, DrawsDifferencesWhereAStepShowsThem) {
    std::string differing = small;
    const std::string before = "run_to = 3\n";
    differing.insert(differing.find(before), "mode = \"difference\"\n");
    write("small.toml", differing);
    EXPECT_EQ(whorl("lesson small.toml --pictures .").code, 0);
    EXPECT_EQ(whorl("run small-1.png --difference --picture difference.png").code, 0);
    EXPECT_EQ(whorl("run small-1.png --picture plain.png").code, 0);
    EXPECT_EQ(read_png(folder / "small-1.png"), read_png(folder / "difference.png"));
    EXPECT_NE(read_png(folder / "small-1.png"), read_png(folder / "plain.png"));
}

TEST_F(CommandLine, SaysWhatIsWrongWithALesson) {
    write("broken.toml", std::string(small) + "mesure = \"L1\"\n");
    const std::pair<const char*, const char*> cases[] = {
        {"lesson smaer", "unknown lesson \"smaer\"; did you mean smear?"},
        {"lesson none.toml", "none.toml: there is no such file"},
        {"lesson broken.toml", "broken.toml:31:1: unknown key \"mesure\"; did you mean measure?"},
        {"lesson smear --pictures nowhere", "--pictures nowhere: there is no such folder"},
    };
    for (const auto& [arguments, reason] : cases) {
        const Outcome o = whorl(arguments);
        EXPECT_EQ(o.code, 2) << o.out;
        EXPECT_NE(o.out.find(reason), std::string::npos) << o.out;
        EXPECT_EQ(o.lines(), 1u) << o.out;
    }
}

}  // namespace
}  // namespace whorl
