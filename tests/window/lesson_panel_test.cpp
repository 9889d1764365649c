// The lessons' panel, drawn and walked through without a display.
#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include <chrono>
#include <thread>

#include "app/panels/lesson_panel.h"
#include "app/panels/lesson_text.h"
#include "tests/support/headless_ui.h"

namespace whorl::app {
namespace {

/// A column of the panel's least width at the right of the screen, as frames of the window draw it.
struct LessonWindow {
    explicit LessonWindow(HeadlessUi& headless) : ui(headless) {
        frames.add(16.7, 5);
        remote.begin_frame();
    }

    void frame() {
        player.begin_frame();
        remote.begin_frame();
        const SessionSnapshot& session = remote.session();
        // As the window does: it must not take away what a step asks for.
        if (!available(*view.shown, remote.snapshot())) view.shown = &views().front();
        if (session.lanes.size() == 1) {
            view.compare = Compare::SideBySide;
            view.difference = false;
        }
        names.update(session.setup);
        fields.update(session, *view.shown, view.difference);
        slabs.clear();
        PanelContext context{ui.theme, remote, view,  measures, files, history,
                             frames,   fields, names, hover,    trace, slabs};
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        const float width = ui.theme.px(lesson_column_width);
        const float margin = ui.theme.px(8);
        ui.frame([&] {
            ImGui::SetNextWindowPos({screen.x - width - margin, margin});
            ImGui::SetNextWindowSize({width, screen.y - 2 * margin});
            ImGui::Begin("lessons", nullptr,
                         ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings);
            draw_lesson_panel(context, walk);
            column = ImGui::GetCurrentWindow()->Rect();
            ImGui::End();
            hover.end_frame();
        });
    }
    template <class IsSo>
    bool eventually(IsSo&& is_so, int patience = 1500) {
        for (int k = 0; k < patience; ++k) {
            frame();
            if (is_so()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }
    void press(int key) {
        EXPECT_TRUE(walk.take({.kind = InputEvent::Kind::Key, .code = key}, remote, view));
        frame();
    }
    /// Clicks a control by its name in the trace.
    void click(const char* key) {
        const auto place = trace.places().in_sight(key);
        ASSERT_TRUE(place) << key;
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {place->x + 0.5f * place->width, place->y + 0.5f * place->height};
        for (const bool down : {false, true, false}) {
            io.MouseDown[0] = down;
            frame();
        }
        io.MousePos = {-FLT_MAX, -FLT_MAX};
        frame();
    }
    /// Whether everything is as the step says.
    bool shows(const LessonStep& step) const {
        const Compare compare = step.mode == LessonMode::One    ? Compare::One
                                : step.mode == LessonMode::Wipe ? Compare::Wipe
                                                                : Compare::SideBySide;
        return remote.session().setup == step.recording.setup &&
               remote.session().step == step.recording.step && view.shown == step.view &&
               view.compare == compare && view.difference == (step.mode == LessonMode::Difference) &&
               !remote.playing();
    }

    HeadlessUi& ui;
    Player player{{.setup = {}}, 1};
    Notices notices;
    Remote remote{player, notices};
    ViewState view;
    MeasureView measures;
    FileDesk files;
    History history;
    FrameLog frames;
    LaneFields fields;
    LaneNames names;
    HoverHelp hover;
    Trace trace{""};
    Slabs slabs;
    LessonWalk walk;
    ImRect column;
};

/// The windows within the panel's: its scrolled parts.
std::vector<const ImGuiWindow*> parts() {
    std::vector<const ImGuiWindow*> found;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        if (window->WasActive && std::string_view(window->Name).starts_with("lessons"))
            found.push_back(window);
    }
    return found;
}

/// ImGui rounds the width of a text up to whole pixels.
constexpr float rounding = 1;

void expect_no_text_is_cut(const LessonWindow& window, const std::string& what) {
    for (const ImGuiWindow* part : parts()) {
        EXPECT_LE(part->ContentSize.x, part->InnerRect.GetWidth() - 2 * part->WindowPadding.x + rounding)
            << what << ", " << part->Name;
        EXPECT_GE(part->InnerRect.Min.x, window.column.Min.x) << what;
        EXPECT_LE(part->InnerRect.Max.y, window.column.Max.y) << what;
    }
    // What does not scroll is within the column.
    const ImGuiWindow* panel = ImGui::FindWindowByName("lessons");
    EXPECT_LE(panel->ContentSize.y, panel->InnerRect.GetHeight() - 2 * panel->WindowPadding.y + rounding)
        << what;
    EXPECT_EQ(panel->ScrollMax.y, 0) << what;
}

/// Lines of formulas stand as they are written: none is so long that it must be wrapped.
void expect_formulas_fit(const Theme& theme, const LessonStep& step) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float card = 2 * theme.px(8);
    const float room = theme.px(lesson_column_width) - 2 * style.WindowPadding.x - style.ScrollbarSize - card;
    for (const Block& block : step.text) {
        if (block.kind != Block::Kind::Formula) continue;
        const float width = theme.mono->CalcTextSizeA(theme.mono->FontSize, FLT_MAX, 0, block.text.c_str()).x;
        EXPECT_LE(width, room) << block.text;
    }
}

void expect_letters(const Theme& theme, const std::string& text) {
    for (const char* at = text.c_str(); *at != '\0';) {
        unsigned int letter = 0;
        at += ImTextCharFromUtf8(&letter, at, nullptr);
        if (letter == '\n') continue;
        for (const ImFont* font : {theme.body, theme.bold, theme.mono}) {
            EXPECT_NE(font->FindGlyphNoFallback(static_cast<ImWchar>(letter)), nullptr)
                << "U+" << std::hex << letter << " of: " << text;
        }
    }
}

class LessonPanel : public testing::TestWithParam<float> {};

TEST_P(LessonPanel, CutsNothingOffOnAProjector) {
    HeadlessUi ui(1024, 768, GetParam());
    LessonWindow window(ui);
    window.walk.set_open(true, window.remote);
    for (int frame = 0; frame < 3; ++frame) window.frame();
    expect_no_text_is_cut(window, "list");
    for (const Lesson& lesson : lessons()) {
        window.walk.begin(lesson, window.remote, window.view);
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            for (int frame = 0; frame < 3; ++frame)
                window.frame();  // a scroll bar takes its room in the second
            expect_no_text_is_cut(window, lesson.key + " " + std::to_string(k + 1));
            expect_formulas_fit(ui.theme, window.walk.step());
            window.walk.next(window.remote, window.view);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scale, LessonPanel, testing::Values(1.0f, 2.0f));

TEST(LessonPanelText, BreaksBetweenWordsThatMayPart) {
    HeadlessUi ui(300, 300, 1.0f);
    std::string few, many, whole;
    ui.frame([&] {
        few = broken("as in [3.11], with ζ = 2 and a share of 49 %", 1);
        many = broken("as in [3.11], with ζ = 2 and a share of 49 %", 1e6f);
        whole = broken("", 10) + broken("a  b ", 1);
    });
    EXPECT_EQ(few, "as\nin\n[3.11],\nwith\nζ = 2\nand\na\nshare\nof\n49 %");
    EXPECT_EQ(many, "as in [3.11], with ζ = 2 and a share of 49 %");
    EXPECT_EQ(whole, "a\nb");
}

TEST(LessonPanelText, HasAGlyphForEveryLetter) {
    HeadlessUi ui(300, 300, 1.0f);
    for (const Lesson& lesson : lessons()) {
        expect_letters(ui.theme, lesson.title + lesson.summary);
        for (const LessonStep& step : lesson.steps) {
            expect_letters(ui.theme, step.title);
            for (const Block& block : step.text) expect_letters(ui.theme, block.text);
            for (const std::string& text : step.tries) expect_letters(ui.theme, text);
        }
    }
}

/// Three steps that differ in all that a step sets.
Lesson walked_lesson() {
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
                        "walked");
}

TEST(LessonPanelWalk, ShowsEachStepInOneGo) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    const Lesson lesson = walked_lesson();
    window.walk.begin(lesson, window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    EXPECT_EQ(window.remote.loaded(), "rest");
    window.press(GLFW_KEY_PAGE_UP);
    EXPECT_TRUE(window.walk.first());
    window.press(GLFW_KEY_PAGE_DOWN);
    // The exact solution is known at the step's moment alone, and shown there.
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    EXPECT_EQ(window.remote.selected(), 0u);
    EXPECT_EQ(window.remote.other(), 1u);
    window.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[2]); }));
    EXPECT_TRUE(window.walk.last());
    window.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_EQ(window.walk.place(), 2u);
    window.press(GLFW_KEY_PAGE_UP);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    window.walk.leave();
    window.frame();
    EXPECT_EQ(window.walk.lesson(), nullptr);
    EXPECT_TRUE(window.shows(lesson.steps[1]));
}

TEST(LessonPanelWalk, ShowsAgainWhatWasPlayedWith) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    const Lesson lesson = walked_lesson();
    window.walk.begin(lesson, window.remote, window.view);
    window.walk.next(window.remote, window.view);
    window.walk.next(window.remote, window.view);
    ASSERT_TRUE(window.eventually([&] { return window.shows(lesson.steps[2]); }));
    window.remote.set(parameter("beta"), 0.1);
    window.remote.play(true);
    window.view.shown = &view("speed");
    window.view.compare = Compare::One;
    ASSERT_TRUE(window.eventually([&] { return window.remote.session().step > 20; }));
    EXPECT_EQ(window.view.shown, &view("speed"));
    window.walk.show(window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[2]); }));
}

TEST(LessonPanelWalk, TurnsPagesFasterThanRunsBegin) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    const Lesson lesson = walked_lesson();
    window.walk.begin(lesson, window.remote, window.view);
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
        while (!window.walk.last()) window.walk.next(window.remote, window.view);
        window.frame();
    };
    window.walk.begin(lessons()[0], window.remote, window.view);
    to_its_end();
    window.click("lesson-next");
    EXPECT_EQ(window.walk.lesson(), &lessons()[1]);
    EXPECT_EQ(window.walk.place(), 0u);
    EXPECT_TRUE(window.walk.keeps_run(window.remote));
    window.walk.begin(lessons().back(), window.remote, window.view);
    to_its_end();
    window.click("lesson-next");
    EXPECT_EQ(window.walk.lesson(), nullptr);
    EXPECT_TRUE(window.walk.open());
}

/// A person's own run: something was done in it, and it is looked at in a way of its own.
void make_own_run(LessonWindow& window) {
    Scene scene;
    scene.resolution = 16;
    window.remote.load("own", {.setup = {scene, {LaneSetup{.name = "A"}, LaneSetup{.name = "B"}}}});
    ASSERT_TRUE(window.eventually([&] { return window.remote.session().lanes.size() == 2; }));
    window.remote.play(true);
    ASSERT_TRUE(window.eventually([&] { return window.remote.session().step >= 5; }));
    window.remote.set(parameter("beta"), 0.1);
    ASSERT_TRUE(window.eventually([&] { return window.remote.session().step >= 20; }));
    window.remote.select(1);
    window.view.shown = &view("speed");
    window.view.compare = Compare::Wipe;
    window.view.wipe = 0.25f;
    window.view.window = {{0.25f, 0.25f}, {0.75f, 0.75f}};
}

/// The bits of a step of the run on screen.
std::uint64_t digest_at(LessonWindow& window, long step) {
    window.remote.seek(step);
    EXPECT_TRUE(
        window.eventually([&] { return !window.remote.sought() && window.remote.session().step == step; }));
    return window.remote.session().digest();
}

TEST(LessonPanelWalk, GivesTheRunBackThatItTookThePlaceOf) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    make_own_run(window);
    const std::uint64_t later = digest_at(window, 20);
    const std::uint64_t digest = digest_at(window, 11);
    const ViewWindow zoom = window.view.window;
    const long last = window.remote.session().last_step;
    const Lesson lesson = walked_lesson();
    window.walk.begin(lesson, window.remote, window.view);
    EXPECT_TRUE(window.walk.keeps_run(window.remote));
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    // What is done in a lesson's run, and the way to another lesson, leave it kept.
    window.remote.restart();
    window.remote.set(parameter("beta"), 0.3);
    window.walk.leave();
    window.frame();
    EXPECT_TRUE(window.walk.keeps_run(window.remote));
    window.walk.begin(lesson, window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));

    window.walk.set_open(false, window.remote);
    EXPECT_TRUE(window.eventually([&] {
        return window.remote.loaded() == "own" && window.remote.session().step == 11 &&
               !window.remote.sought();
    }));
    window.frame();
    EXPECT_EQ(window.remote.session().digest(), digest);
    EXPECT_EQ(window.remote.session().last_step, last);
    EXPECT_FALSE(window.remote.playing()) << "it stood";
    EXPECT_EQ(window.view.shown, &view("speed"));
    EXPECT_EQ(window.view.compare, Compare::Wipe);
    EXPECT_EQ(window.view.wipe, 0.25f);
    EXPECT_EQ(window.view.window.low, zoom.low);
    EXPECT_EQ(window.view.window.high, zoom.high);
    EXPECT_EQ(window.remote.selected(), 1u);
    EXPECT_EQ(digest_at(window, 20), later) << "what was done after the step is there as well";
    EXPECT_FALSE(window.walk.keeps_run(window.remote));
}

TEST(LessonPanelWalk, GivesBackARunThatPlays) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    make_own_run(window);
    const Lesson lesson = walked_lesson();
    window.walk.begin(lesson, window.remote, window.view);
    const long at = window.remote.session().step;
    // Closed and opened again before the run has come back: it is kept on.
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.walk.set_open(false, window.remote);
    window.frame();
    window.frame();
    window.walk.begin(lesson, window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.walk.set_open(false, window.remote);
    EXPECT_TRUE(window.eventually([&] {
        return window.remote.loaded() == "own" && window.remote.playing() &&
               window.remote.session().step > at;
    }));
}

TEST(LessonPanelWalk, LeavesWhatSomeoneHasLoadedSince) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    make_own_run(window);
    const Lesson lesson = walked_lesson();
    window.walk.begin(lesson, window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    Scene other;
    other.resolution = 12;
    window.remote.load("other", {.setup = {.scene = other}});
    EXPECT_FALSE(window.walk.keeps_run(window.remote));
    // It is kept in its turn when a step takes its place.
    ASSERT_TRUE(window.eventually([&] { return window.remote.session().setup.scene.resolution == 12; }));
    window.walk.next(window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[1]); }));
    window.walk.set_open(false, window.remote);
    EXPECT_TRUE(
        window.eventually([&] { return window.remote.loaded() == "other" && !window.remote.sought(); }));

    window.walk.begin(lesson, window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    window.remote.load("last", {.setup = {.scene = other}});
    window.walk.set_open(false, window.remote);
    ASSERT_TRUE(window.eventually([&] { return window.remote.session().setup.scene.resolution == 12; }));
    for (int k = 0; k < 20; ++k) window.frame();
    EXPECT_EQ(window.remote.loaded(), "last");
    EXPECT_EQ(window.remote.session().setup.scene.resolution, 12) << "and it stays";
}

TEST(LessonPanelWalk, SaysThatARunIsTooLongToComeBack) {
    HeadlessUi ui(1024, 768, 1.0f);
    LessonWindow window(ui);
    Scene scene;
    scene.resolution = 8;
    window.remote.load("own", {.setup = {.scene = scene}});
    ASSERT_TRUE(window.eventually([&] { return window.remote.session().setup.scene.resolution == 8; }));
    for (std::size_t k = 0; k <= Recording::max_commands; ++k)
        window.player.push(SetParameter{"beta", k % 2 == 0 ? "0.1" : "0.2"});
    ASSERT_TRUE(window.eventually([&] { return !window.remote.session().complete; }));
    const Lesson lesson = walked_lesson();
    window.walk.begin(lesson, window.remote, window.view);
    EXPECT_TRUE(window.eventually([&] { return window.shows(lesson.steps[0]); }));
    EXPECT_FALSE(window.walk.keeps_run(window.remote));
    EXPECT_EQ(window.notices.shown().size(), 1u);
    window.walk.set_open(false, window.remote);
    for (int k = 0; k < 20; ++k) window.frame();
    EXPECT_TRUE(window.shows(lesson.steps[0]));
}

}  // namespace
}  // namespace whorl::app
