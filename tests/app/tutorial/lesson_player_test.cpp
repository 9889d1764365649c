// A student's way through a lesson: its runs and views, and one's own run that comes back.
#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/support/lesson_window.h"

namespace whorl::app {
namespace {

/// Three steps that differ in all that a step sets.
Lesson small_lesson() {
    return parse_lesson(R"(
whorl = 1
title = "T"
summary = "S"
[[step]]
title = "one"
text = "a"
scene = "rest"
set = ["resolution=16"]
[[step]]
title = "two"
text = "b"
scene = "rotation"
set = ["resolution=12"]
view = "difference"
mode = "wipe"
run_to = 600
[[step.lane]]
name = "A"
[[step.lane]]
name = "B"
set = ["advector=aslam", "interpolation=linear"]
[[step]]
title = "three"
text = "c"
scene = "plume"
set = ["resolution=16"]
lanes = "tracers"
view = "vorticity"
mode = "difference"
run_to = 7
)",
                        "small");
}

TEST(LessonPanelWalk, ShowsEachStepInOneGo) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    const Lesson lesson = small_lesson();
    window.lesson_player.begin(lesson);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    EXPECT_EQ(window.client.loaded(), "rest");
    window.press(GLFW_KEY_PAGE_UP);
    EXPECT_TRUE(window.lesson_player.first());
    window.press(GLFW_KEY_PAGE_DOWN);
    // The exact solution is known at the step's moment alone, and shown there.
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    EXPECT_EQ(window.client.selected(), 0u);
    EXPECT_EQ(window.client.other(), 1u);
    window.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[2]); }));
    EXPECT_TRUE(window.lesson_player.last());
    window.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_EQ(window.lesson_player.place(), 2u);
    window.press(GLFW_KEY_PAGE_UP);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    window.lesson_player.leave();
    window.frame();
    EXPECT_EQ(window.lesson_player.lesson(), nullptr);
    EXPECT_TRUE(window.shows(lesson.steps[1]));
}

TEST(LessonPanelWalk, ShowsAgainWhatWasPlayedWith) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    const Lesson lesson = small_lesson();
    window.lesson_player.begin(lesson);
    window.lesson_player.next();
    window.lesson_player.next();
    ASSERT_TRUE(window.eventually([&] { return window.shows(lesson.steps[2]); }));
    window.client.set(parameter("beta"), 0.1);
    window.client.play(true);
    window.view.shown = &view("speed");
    window.view.compare = Compare::One;
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step > 20; }));
    EXPECT_EQ(window.view.shown, &view("speed"));
    window.lesson_player.show();
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[2]); }));
}

TEST(LessonPanelWalk, TurnsPagesFasterThanRunsBegin) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    const Lesson lesson = small_lesson();
    window.lesson_player.begin(lesson);
    for (int round = 0; round < 5; ++round) {
        window.press(GLFW_KEY_PAGE_DOWN);
        window.press(GLFW_KEY_PAGE_DOWN);
        window.press(GLFW_KEY_PAGE_UP);
    }
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
}

TEST(LessonPanelWalk, GoesFromALessonToTheNextAndBackToTheList) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    const auto to_its_end = [&] {
        while (!window.lesson_player.last()) window.lesson_player.next();
        window.frame();
    };
    window.lesson_player.begin(lessons()[0]);
    to_its_end();
    window.click("lesson-next");
    EXPECT_EQ(window.lesson_player.lesson(), &lessons()[1]);
    EXPECT_EQ(window.lesson_player.place(), 0u);
    EXPECT_TRUE(window.lesson_player.keeps_run());
    window.lesson_player.begin(lessons().back());
    to_its_end();
    window.click("lesson-next");
    EXPECT_EQ(window.lesson_player.lesson(), nullptr);
    EXPECT_TRUE(window.lesson_player.open());
}

/// A person's own run: something was done in it, and it is looked at in a way of its own.
void make_own_run(LessonWindow& window) {
    Scene scene;
    scene.resolution = 16;
    window.client.load("own", {.setup = {scene, {LaneSetup{.name = "A"}, LaneSetup{.name = "B"}}}});
    ASSERT_TRUE(window.eventually([&] { return window.client.session().lanes.size() == 2; }));
    window.client.play(true);
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step >= 5; }));
    window.client.set(parameter("beta"), 0.1);
    ASSERT_TRUE(window.eventually([&] { return window.client.session().step >= 20; }));
    window.client.select(1);
    window.view.shown = &view("speed");
    window.view.compare = Compare::Wipe;
    window.view.wipe = 0.25f;
    window.view.window = {{0.25f, 0.25f}, {0.75f, 0.75f}};
}

/// The bits of a step of the run on screen.
std::uint64_t digest_at(LessonWindow& window, long step) {
    window.client.seek(step);
    EXPECT_TRUE(window.eventually(
        [&] { return !window.client.seek_target() && window.client.session().step == step; }));
    return window.client.session().digest();
}

TEST(LessonPanelWalk, GivesTheRunBackThatItTookThePlaceOf) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    make_own_run(window);
    const std::uint64_t later = digest_at(window, 20);
    const std::uint64_t digest = digest_at(window, 11);
    const ViewWindow zoom = window.view.window;
    const long last = window.client.session().last_step;
    const Lesson lesson = small_lesson();
    window.lesson_player.begin(lesson);
    EXPECT_TRUE(window.lesson_player.keeps_run());
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    // What is done in a lesson's run, and the way to another lesson, leave it kept.
    window.client.restart();
    window.client.set(parameter("beta"), 0.3);
    window.lesson_player.leave();
    window.frame();
    EXPECT_TRUE(window.lesson_player.keeps_run());
    window.lesson_player.begin(lesson);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));

    window.lesson_player.set_open(false);
    EXPECT_TRUE(window.eventually([&] {
        return window.client.loaded() == "own" && window.client.session().step == 11 &&
               !window.client.seek_target();
    }));
    window.frame();
    EXPECT_EQ(window.client.session().digest(), digest);
    EXPECT_EQ(window.client.session().last_step, last);
    EXPECT_FALSE(window.client.playing()) << "it stood";
    EXPECT_EQ(window.view.shown, &view("speed"));
    EXPECT_EQ(window.view.compare, Compare::Wipe);
    EXPECT_EQ(window.view.wipe, 0.25f);
    EXPECT_EQ(window.view.window.low, zoom.low);
    EXPECT_EQ(window.view.window.high, zoom.high);
    EXPECT_EQ(window.client.selected(), 1u);
    EXPECT_EQ(digest_at(window, 20), later) << "what was done after the step is there as well";
    EXPECT_FALSE(window.lesson_player.keeps_run());
}

TEST(LessonPanelWalk, GivesBackARunThatPlays) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    make_own_run(window);
    const Lesson lesson = small_lesson();
    window.lesson_player.begin(lesson);
    const long at = window.client.session().step;
    // Closed and opened again before the run has come back: it is kept on.
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.lesson_player.set_open(false);
    window.frame();
    window.frame();
    window.lesson_player.begin(lesson);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.lesson_player.set_open(false);
    EXPECT_TRUE(window.eventually([&] {
        return window.client.loaded() == "own" && window.client.playing() &&
               window.client.session().step > at;
    }));
}

TEST(LessonPanelWalk, LeavesWhatSomeoneHasLoadedSince) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    make_own_run(window);
    const Lesson lesson = small_lesson();
    window.lesson_player.begin(lesson);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    Scene other;
    other.resolution = 12;
    window.client.load("other", {.setup = {.scene = other}});
    EXPECT_FALSE(window.lesson_player.keeps_run());
    // It is kept in its turn when a step takes its place.
    ASSERT_TRUE(window.eventually([&] { return window.client.session().setup.scene.resolution == 12; }));
    window.lesson_player.next();
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    window.lesson_player.set_open(false);
    EXPECT_TRUE(
        window.eventually([&] { return window.client.loaded() == "other" && !window.client.seek_target(); }));

    window.lesson_player.begin(lesson);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.client.load("last", {.setup = {.scene = other}});
    window.lesson_player.set_open(false);
    ASSERT_TRUE(window.eventually([&] { return window.client.session().setup.scene.resolution == 12; }));
    for (int k = 0; k < 20; ++k) window.frame();
    EXPECT_EQ(window.client.loaded(), "last");
    EXPECT_EQ(window.client.session().setup.scene.resolution, 12) << "and it stays";
}

TEST(LessonPanelWalk, SaysThatARunIsTooLongToComeBack) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    Scene scene;
    scene.resolution = 8;
    window.client.load("own", {.setup = {.scene = scene}});
    ASSERT_TRUE(window.eventually([&] { return window.client.session().setup.scene.resolution == 8; }));
    for (std::size_t k = 0; k <= Recording::max_commands; ++k)
        window.player.push(SetParameter{"beta", k % 2 == 0 ? "0.1" : "0.2"});
    ASSERT_TRUE(window.eventually([&] { return !window.client.session().complete; }));
    const Lesson lesson = small_lesson();
    window.lesson_player.begin(lesson);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    EXPECT_FALSE(window.lesson_player.keeps_run());
    EXPECT_EQ(window.notifications.shown().size(), 1u);
    window.lesson_player.set_open(false);
    for (int k = 0; k < 20; ++k) window.frame();
    EXPECT_TRUE(window.shows(lesson.steps[0]));
}

}  // namespace
}  // namespace whorl::app
