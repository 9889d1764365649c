// The lessons that come with the program, and how claims are measured.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "app/lessons/lesson_run.h"
#include "core/base/error.h"

namespace whorl::app {
namespace {

TEST(Lessons, AreEightAndSay) {
    EXPECT_GE(lessons().size(), 8u);
    std::set<std::string> keys;
    for (const Lesson& lesson : lessons()) {
        EXPECT_TRUE(keys.insert(lesson.key).second) << lesson.key;
        EXPECT_GE(lesson.steps.size(), 4u) << lesson.key;
        EXPECT_LE(lesson.steps.size(), 7u) << lesson.key;
        std::size_t claims = 0;
        for (const LessonStep& step : lesson.steps) {
            claims += step.claims.size();
            EXPECT_FALSE(step.tries.empty()) << lesson.key << ": " << step.title;
        }
        EXPECT_GE(claims, 5u) << lesson.key;
    }
}

/// A lesson of one scene of a few cells.
Lesson small_lesson(const std::string& steps) {
    return parse_lesson("whorl = 1\ntitle = \"T\"\nsummary = \"S\"\n" + steps, "small");
}

constexpr const char* two_steps = R"(
[[step]]
title = "one"
text = "a"
scene = "taylor-green"
set = ["resolution=12"]
run_to = 4
[[step.lane]]
name = "SL"
[[step.lane]]
name = "MC"
set = ["advector=maccormack"]
[[step.claim]]
measure = "kinetic_energy"
lane = "SL"
over_lane = "MC"
at_most = 1
[[step.claim]]
measure = "kinetic_energy"
lane = "SL"
at = 9
over_at = 2
at_most = 1
[[step.claim]]
measure = "effective_viscosity"
lane = "SL"
at_least = 0
[[step]]
title = "two"
text = "b"
run_to = 12
[[step.claim]]
measure = "L1"
lane = "MC"
at = 3
at_most = 1
[[step.claim]]
measure = "limited_density"
lane = "MC"
at = 5
at_least = 0
[[step.claim]]
measure = "divergence_after"
lane = "MC"
at = 5
at_most = 1
)";

TEST(LessonRun, MeasuresWhatASessionMeasures) {
    const Lesson lesson = small_lesson(two_steps);
    const LessonStep &one = lesson.steps[0], &two = lesson.steps[1];
    Pool pool(1);
    Session session({.setup = one.recording.setup}, pool);
    std::vector<std::array<Measures, 2>> expected{{session.measures(0), session.measures(1)}};
    while (session.step_number() < 12) {
        session.step();
        expected.push_back({session.measures(0), session.measures(1)});
    }
    LessonRun run(pool);
    run.enter(one);
    EXPECT_EQ(run.measure(one.claims[0]), expected[4][0].kinetic_energy / expected[4][1].kinetic_energy);
    EXPECT_EQ(run.measure(one.claims[1]), expected[9][0].kinetic_energy / expected[2][0].kinetic_energy);
    double sum = 0;
    for (std::size_t k = 1; k <= 4; ++k) sum += expected[k][0].effective_viscosity;
    EXPECT_EQ(run.measure(one.claims[2]), sum / 4);
    EXPECT_EQ(run.look(one).step, 4);
    // The second step goes on with the first one's run.
    run.enter(two);
    EXPECT_EQ(run.measure(two.claims[0]), expected[3][1].errors.L1);
    EXPECT_GE(run.measure(two.claims[1]), 0) << "what is not watched of itself is watched where a claim asks";
    EXPECT_EQ(run.measure(two.claims[2]), expected[5][1].divergence_after);
    const SessionSnapshot snapshot = run.look(two);
    EXPECT_EQ(snapshot.step, 12);
    EXPECT_EQ(snapshot.digest(), session.digest());
}

TEST(LessonRun, TheDocumentsExampleHolds) {
    std::ifstream file(WHORL_TEST_DATA "/../docs/lessons.md");
    std::stringstream document;
    document << file.rdbuf();
    const std::string text = document.str(), opening = "```toml\n";
    const std::size_t begin = text.find(opening) + opening.size();
    const Lesson lesson = parse_lesson(text.substr(begin, text.find("```", begin) - begin), "example");
    ASSERT_EQ(lesson.steps.size(), 2u);
    Pool pool(1);
    LessonRun run(pool);
    for (const LessonStep& step : lesson.steps) {
        run.enter(step);
        for (const Claim& claim : step.claims) EXPECT_TRUE(claim.holds(run.measure(claim))) << step.title;
    }
}

TEST(LessonRun, AnUnknownNumberHoldsNothing) {
    const Lesson lesson = small_lesson(R"(
[[step]]
title = "one"
text = "a"
scene = "plume"
set = ["resolution=8"]
run_to = 1
[[step.claim]]
measure = "L1"
at_least = -100
)");
    Pool pool(1);
    LessonRun run(pool);
    run.enter(lesson.steps.front());
    const double value = run.measure(lesson.steps.front().claims.front());
    EXPECT_TRUE(std::isnan(value));
    EXPECT_FALSE(lesson.steps.front().claims.front().holds(value));
}

TEST(Claim, SaysWhatItIsAbout) {
    const Lesson lesson = small_lesson(two_steps);
    const LessonStep& one = lesson.steps[0];
    const auto& setup = one.recording.setup;
    EXPECT_EQ(describe(one.claims[0], setup),
              "kinetic_energy of SL at step 4 over kinetic_energy of MC at step 4");
    EXPECT_EQ(bounds(one.claims[0]), "at most 1");
    EXPECT_EQ(bounds(one.claims[2]), "at least 0");
    EXPECT_EQ(one.claims[1].last_step(), 9);
}

}  // namespace
}  // namespace whorl::app
