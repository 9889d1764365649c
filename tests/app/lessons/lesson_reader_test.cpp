// How lessons are read, and what is said of those that cannot be.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "app/lessons/lesson.h"
#include "app/scenes/comparisons.h"
#include "core/base/error.h"

namespace whorl::app {
namespace {

constexpr const char* head = "whorl = 1\ntitle = \"T\"\nsummary = \"S\"\n";
constexpr const char* step = "[[step]]\ntitle = \"one\"\ntext = \"a\"\nscene = \"rest\"\n";

Lesson read(const std::string& text) {
    return parse_lesson(text, "l.toml");
}

std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& e) {
        return e.what();
    }
    return "accepted";
}

/// What is said of a lesson whose one step ends with these lines.
std::string of_step(const std::string& lines) {
    return refusal(std::string(head) + step + lines);
}

TEST(LessonReader, ReadsAWholeStep) {
    const Lesson lesson = read(std::string(head) + R"(
[[step]]
title = "Look"
text = '''
# Why
Because.
'''
try = ["this", "that"]
scene = "translation"
set = ["resolution=20", "interpolation=linear"]
view = "difference"
mode = "wipe"
run_to = 30
reference = 1
[[step.lane]]
name = "A"
[[step.lane]]
name = "B"
refine = 2
set = ["advector=aslam"]
[[step.claim]]
measure = "L1"
lane = "B"
is = 2.5
within = 0.5
[[step.claim]]
measure = "max"
lane = "A"
at = 7
over_lane = "B"
over_at = 0
at_most = 1
)");
    EXPECT_EQ(lesson.key, "l.toml");
    EXPECT_EQ(lesson.title, "T");
    ASSERT_EQ(lesson.steps.size(), 1u);
    const LessonStep& s = lesson.steps.front();
    EXPECT_EQ(s.text,
              (std::vector<Block>{{Block::Kind::Heading, "Why"}, {Block::Kind::Paragraph, "Because."}}));
    EXPECT_EQ(s.tries, (std::vector<std::string>{"this", "that"}));
    EXPECT_EQ(s.recording.setup.scene.resolution, 20);
    EXPECT_EQ(s.recording.setup.lanes[1],
              (LaneSetup{.name = "B", .overrides = {{"advector", "aslam"}}, .refine = 2}));
    EXPECT_EQ(s.recording.setup.reference, 1);
    EXPECT_EQ(s.recording.step, 30);
    EXPECT_EQ(s.view, &view("difference"));
    EXPECT_EQ(s.mode, LessonMode::Wipe);
    ASSERT_EQ(s.claims.size(), 2u);
    EXPECT_EQ(s.claims[0].place, (LaneAtStep{1, 30}));
    EXPECT_EQ(std::pair(s.claims[0].line, s.claims[0].column), std::pair(24u, 1u));
    EXPECT_EQ(std::pair(s.claims[1].line, s.claims[1].column), std::pair(29u, 1u));
    EXPECT_FALSE(s.claims[0].over);
    EXPECT_TRUE(s.claims[0].holds(2.0) && s.claims[0].holds(3.0));
    EXPECT_FALSE(s.claims[0].holds(1.9) || s.claims[0].holds(3.1) || s.claims[0].holds(std::nan("")));
    EXPECT_EQ(s.claims[1].place, (LaneAtStep{0, 7}));
    EXPECT_EQ(s.claims[1].over, (LaneAtStep{1, 0}));
    EXPECT_TRUE(s.claims[1].holds(-5));
}

TEST(LessonReader, AStepKeepsWhatItDoesNotGive) {
    const Lesson lesson = read(std::string(head) + R"(
[[step]]
title = "one"
text = "a"
scene = "plume"
set = ["resolution=24"]
lanes = "limiters"
view = "vorticity"
mode = "one"
run_to = 9
try = ["x"]
[[step.claim]]
measure = "max"
lane = "MC clamped"
at_least = 0
[[step]]
title = "two"
text = "b"
set = ["beta=0.5"]
[[step]]
title = "three"
text = "c"
scene = "rest"
)");
    ASSERT_EQ(lesson.steps.size(), 3u);
    const LessonStep &one = lesson.steps[0], &two = lesson.steps[1], &three = lesson.steps[2];
    EXPECT_EQ(one.recording.setup.lanes, find_lanes("limiters").lanes);
    EXPECT_EQ(two.recording.setup.lanes, one.recording.setup.lanes);
    EXPECT_EQ(two.recording.setup.scene.resolution, 24);
    EXPECT_EQ(two.recording.setup.scene.beta, 0.5);
    EXPECT_EQ(two.recording.step, 9);
    EXPECT_EQ(two.view, one.view);
    EXPECT_EQ(two.mode, LessonMode::One);
    EXPECT_TRUE(two.tries.empty() && two.claims.empty());
    // A scene begins anew.
    EXPECT_EQ(three.recording.setup.scene.resolution, 40);
    EXPECT_EQ(three.recording.setup.lanes.size(), 1u);
    EXPECT_EQ(three.recording.step, 0);
    EXPECT_EQ(three.view, views().front());
    EXPECT_EQ(three.mode, LessonMode::SideBySide);
}

TEST(LessonReader, NamesTheLineOfWhatIsWrong) {
    // The step's own lines begin with the eighth.
    const std::pair<const char*, const char*> cases[] = {
        {"veiw = \"speed\"", "l.toml:8:1: unknown key \"veiw\"; did you mean view"},
        {"view = \"sped\"", "l.toml:8:8: unknown view \"sped\"; did you mean speed?"},
        {"mode = \"wype\"", "l.toml:8:8: unknown mode \"wype\""},
        {"run_to = -1", "l.toml:8:10: run_to is not a whole number from 0"},
        {"run_to = 1.5", "l.toml:8:10: run_to"},
        {"set = [\n\"zeta=3\",\n\"zeat=2\"]", "l.toml:10:1: unknown parameter \"zeat\""},
        {"set = \"zeta=3\"", "l.toml:8:7: set is a list"},
        {"set = [\"advector=aslam\", \"interpolation=bridson\"]", "l.toml:4:1: "},
        {"lanes = \"tracer\"", "l.toml:8:9: unknown comparison \"tracer\""},
        {"lanes = \"tracers\"\n[[step.lane]]\nname = \"a\"", "l.toml:8:9: lanes names a comparison"},
        {"reference = 3", "l.toml:4:1: the reference is none of the lanes"},
        {"try = \"this\"", "l.toml:8:7: try is a list"},
        {"try = [\"a\\u0007\"]", "l.toml:8:8: an item of try holds a control character"},
        {"try = [\"a\\nb\"]", "l.toml:8:8: an item of try is more than one line"},
        {"view = \"so\nand", "l.toml:8:11: a text ends in the line that it begins in"},
        {"view = \"\"\"so\nand", "l.toml:9:4: a text is not closed"},
        {"set = [1,", "l.toml:8:10: a list is not closed"},
        {"mode = side", "l.toml:8:8: this is no value; a text stands in \"quotes\""},
        {"claim = 3", "l.toml:8:9: claim is a list"},
        {"[[step.claim]]\nis = 3\nwithin = 1", "l.toml:8:1: a claim has no measure"},
        {"[[step.claim]]\nmeasure = \"L3\"\nis = 3\nwithin = 1", "l.toml:9:11: unknown measure \"L3\""},
        {"[[step.claim]]\nmeasure = \"step_ms\"\nis = 3\nwithin = 1",
         "l.toml:9:11: step_ms is a time of the machine's"},
        {"[[step.claim]]\nmeasure = \"L1\"\nis = 3", "l.toml:8:1: a claim says is and within"},
        {"[[step.claim]]\nmeasure = \"L1\"", "l.toml:8:1: a claim says is and within"},
        {"[[step.claim]]\nmeasure = \"L1\"\nis = 3\nwithin = -1", "l.toml:8:1: a claim says is and within"},
        {"[[step.claim]]\nmeasure = \"L1\"\nat_least = 2\nat_most = 1", "l.toml:8:1: a claim says"},
        {"[[step.claim]]\nmeasure = \"L1\"\nis = 3\nwithin = 1\nat_most = 4", "l.toml:8:1: a claim says"},
        {"[[step.claim]]\nmeasure = \"L1\"\nis = inf\nwithin = 1", "l.toml:10:6: is is out of range"},
        {"[[step.claim]]\nmeasure = \"L1\"\nat = 100000\nis = 3\nwithin = 1", "l.toml:10:6: at is not"},
        {"[[step.lane]]\nname = \"a\"\n[[step.lane]]\nname = \"b\"\n[[step.claim]]\nmeasure = "
         "\"L1\"\nat_most = 1",
         "l.toml:12:1: a claim about several lanes has no lane"},
        {"[[step.claim]]\nmeasure = \"L1\"\nlane = \"b\"\nat_most = 1",
         "l.toml:10:8: no lane is called \"b\""},
        {"[[step.claim]]\nmeasure = \"L1\"\nlane = \"Δt = 1/60\"\nat_most = 1\n[[step.lane]]\nname = \"Δt = "
         "1\"\n[[step.lane]]\nname = \"Δt = 1/6\"",
         "l.toml:10:8: no lane is called \"Δt = 1/60\"; did you mean Δt = 1/6?"},
        {"[[step.lane]]\nname = \"a\"\n[[step.lane]]\n[[step.lane]]\n[[step.lane]]\nname = \"a\"",
         "l.toml:13:8: two lanes of a step are called \"a\""},
        {"[[step]]\ntext = \"b\"", "l.toml:8:1: a step has no title"},
        {"[[step]]\ntitle = \"b\"\ntext = \"\"", "l.toml:10:8: text is empty"},
        {"[[step]]\ntitle = \"b\"\ntext = 3", "l.toml:10:8: text is not a text"},
        {"[[step]]\ntitle = \"b\"\ntext = \"b\"\nscene = \"rset\"",
         "l.toml:11:9: unknown preset \"rset\"; did you"},
    };
    for (const auto& [lines, reason] : cases) {
        const std::string said = of_step(lines);
        EXPECT_EQ(said.substr(0, std::string(reason).size()), reason) << lines << "\n" << said;
        EXPECT_EQ(said.find('\n'), said.npos) << said;
    }
}

TEST(LessonReader, RefusesWhatIsNoLesson) {
    EXPECT_EQ(refusal("").substr(0, 10), "l.toml:1:1");
    EXPECT_EQ(refusal("whorl = 2\n").substr(0, 10), "l.toml:1:9");
    EXPECT_NE(refusal("whorl = 1\n").find("a lesson has no title"), std::string::npos);
    EXPECT_NE(refusal(head).find("a lesson has no steps"), std::string::npos);
    EXPECT_EQ(refusal(std::string(head) + "[[step]]\ntitle = \"a\"\ntext = \"b\""),
              "l.toml:4:1: the first step has no scene");
    EXPECT_NE(refusal("whorl = 1\ntitle = [").find("l.toml:2:"), std::string::npos);
}

TEST(LessonReader, StandsHostileText) {
    std::string many(head);
    for (int k = 0; k < 101; ++k) many += step;
    EXPECT_NE(refusal(many).find("there are at most 100"), std::string::npos);
    EXPECT_NE(refusal(std::string((1 << 20) + 1, ' ')).find("too long"), std::string::npos);
    EXPECT_NE(refusal(std::string(head) + std::string(100'000, '[')).find("l.toml:4:"), std::string::npos);
    EXPECT_NE(of_step("scene" + std::string(1000, '.') + " = 1").find("l.toml:8:"), std::string::npos);
    EXPECT_NE(of_step("title = \"\xff\"").find("l.toml:8:"), std::string::npos);
    EXPECT_NE(refusal(std::string(head) + "[[step]]\ntitle = \"a\"\ntext = \"b\"\nscene = \"/dev/zero.toml\"")
                  .find("l.toml:7:9: /dev/zero.toml"),
              std::string::npos);
    std::string wide(head);
    wide += "[[step]]\ntitle = \"a\"\nscene = \"rest\"\ntext = \"" + std::string(500'000, 'x') + "\"\n";
    EXPECT_EQ(read(wide).steps.front().text.front().text.size(), 500'000u);
}

TEST(LessonReader, FindsKeysAndFiles) {
    EXPECT_EQ(find_lesson("smear").key, "smear");
    try {
        find_lesson("smaer");
        FAIL();
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("did you mean smear?"), std::string::npos) << e.what();
    }
    const std::string path = testing::TempDir() + "lesson-" + std::to_string(::getpid()) + ".toml";
    std::ofstream(path) << head << step;
    EXPECT_EQ(find_lesson(path).steps.front().title, "one");
    std::remove(path.c_str());
    EXPECT_THROW(find_lesson(path), InputError);
}

TEST(Markup, SplitsIntoBlocks) {
    using Kind = Block::Kind;
    const std::vector<Block> blocks = blocks_of(
        "\r\n# A heading \nfirst line\n second line\n\nnext\n- item\n  that goes on\n- another\n\n    a = b\n"
        "      + c\nafter\n#no heading\n-5 is a number\n\n    d\n\n    e");
    const std::vector<Block> expected{{Kind::Heading, "A heading"},
                                      {Kind::Paragraph, "first line second line"},
                                      {Kind::Paragraph, "next"},
                                      {Kind::Item, "item that goes on"},
                                      {Kind::Item, "another"},
                                      {Kind::Formula, "a = b\n  + c"},
                                      {Kind::Paragraph, "after #no heading -5 is a number"},
                                      {Kind::Formula, "d"},
                                      {Kind::Formula, "e"}};
    EXPECT_EQ(blocks, expected);
    EXPECT_TRUE(blocks_of("").empty());
    EXPECT_TRUE(blocks_of(" \n\t\n").empty());
}

}  // namespace
}  // namespace whorl::app
