// The lessons' panel cuts nothing off, and has a glyph for every letter.
#include <gtest/gtest.h>

#include "tests/support/lesson_window.h"

namespace whorl::app {
namespace {

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

class LessonPanelFit : public testing::TestWithParam<float> {};

TEST_P(LessonPanelFit, CutsNothingOffOnAProjector) {
    HeadlessUi ui(1024, 768, GetParam());
    LessonWindow window(ui);
    window.lesson_player.set_open(true);
    for (int frame = 0; frame < 3; ++frame) window.frame();
    expect_no_text_is_cut(window, "list");
    for (const Lesson& lesson : lessons()) {
        window.lesson_player.begin(lesson);
        for (std::size_t k = 0; k < lesson.steps.size(); ++k) {
            for (int frame = 0; frame < 3; ++frame)
                window.frame();  // a scroll bar takes its room in the second
            expect_no_text_is_cut(window, lesson.key + " " + std::to_string(k + 1));
            expect_formulas_fit(ui.theme, window.lesson_player.step());
            window.lesson_player.next();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scale, LessonPanelFit, testing::Values(1.0f, 2.0f));

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

}  // namespace
}  // namespace whorl::app
