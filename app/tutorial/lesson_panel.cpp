#include "app/tutorial/lesson_panel.h"

#include <imgui.h>

#include <cmath>

#include "app/ui/widgets.h"
#include "app/ui/wrapped_text.h"

namespace whorl::app {
namespace {

float gap() {
    return ImGui::GetStyle().ItemSpacing.x;
}

bool button(PanelContext& context, const char* label, const char* key, float width, const TooltipText& help) {
    const bool pressed = ImGui::Button(label, {width, 0});
    context.log.control(key);
    context.tooltip.item(context.theme, key, help);
    return pressed;
}

void wrapped(ImFont* font, ImU32 colour, std::string_view line, float margin = 0) {
    ImGui::PushFont(font);
    draw_wrapped(colour, line, margin);
    ImGui::PopFont();
}

/// The first line: where the student is, and the ways out.
void draw_top(PanelContext& context, LessonPlayer& lesson_player) {
    const Theme& theme = context.theme;
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(theme.bold);
    const bool reading = lesson_player.lesson() != nullptr;
    const std::string place = reading ? "Step " + std::to_string(lesson_player.place() + 1) + " of " +
                                            std::to_string(lesson_player.lesson()->steps.size())
                                      : "Lessons";
    text(theme.palette.text, place);
    ImGui::PopFont();
    const float width = theme.px(56);
    const float taken = reading ? 3 * width + 2 * gap() : width;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - taken);
    if (reading) {
        if (button(context, "Plots", "lesson-plots", width,
                   {"", "The measures in the lesson's place. Lesson there, or L, comes back.", "", "", ""}))
            context.view.shows_measures = true;
        ImGui::SameLine();
        if (button(context, "All", "lesson-all", width, {"", "The list of lessons.", "", "", ""}))
            lesson_player.leave();
        ImGui::SameLine();
    }
    if (button(context, "Close", "lesson-close", width,
               {"",
                lesson_player.keeps_run(context.client)
                    ? "Closes the lessons and brings back the run that was here before, as it stood."
                    : "Closes the lessons. The run stays as it is.",
                "Key: L", "", ""}))
        lesson_player.set_open(false, context.client);
    ImGui::Separator();
}

/// A lesson to choose, as wide as the column.
void draw_entry(PanelContext& context, LessonPlayer& lesson_player, const Lesson& lesson, int number) {
    const Theme& theme = context.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetCursorPosX();
    const float width = ImGui::GetContentRegionAvail().x;
    // Text over the button, which is as high as the text turns out to be: that is known after it.
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.ChannelsSplit(2);
    list.ChannelsSetCurrent(1);
    ImGui::BeginGroup();
    ImGui::Dummy({0, theme.px(2)});
    const float indent = left + theme.px(26);
    ImGui::SetCursorPosX(left + theme.px(8));
    text(theme.palette.accent, std::to_string(number));
    ImGui::SameLine(indent);
    const float margin = theme.px(8);
    wrapped(theme.bold, theme.palette.text, lesson.title, margin);
    ImGui::SetCursorPosX(indent);
    wrapped(theme.small, theme.palette.text_dim, lesson.summary, margin);
    ImGui::Dummy({0, theme.px(1)});
    ImGui::EndGroup();
    const float height = ImGui::GetItemRectSize().y;
    const ImVec2 after = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(corner);
    const std::string key = "lesson=" + lesson.key;
    if (ImGui::InvisibleButton(key.c_str(), {width, height}))
        lesson_player.begin(lesson, context.client, context.view);
    context.log.control(key);
    const std::string steps = std::to_string(lesson.steps.size()) + " steps";
    context.tooltip.item(theme, key, {lesson.title, lesson.summary, steps, "", ""});
    list.ChannelsSetCurrent(0);
    list.AddRectFilled(corner, {corner.x + width, corner.y + height},
                       ImGui::IsItemHovered() ? theme.palette.frame : theme.palette.card, theme.px(5));
    list.ChannelsMerge();
    ImGui::SetCursorScreenPos(after);
}

void draw_list(PanelContext& context, LessonPlayer& lesson_player) {
    ImGui::BeginChild("lesson-list");
    int number = 0;
    for (const Lesson& lesson : lessons()) draw_entry(context, lesson_player, lesson, ++number);
    if (lesson_player.own() != nullptr) draw_entry(context, lesson_player, *lesson_player.own(), ++number);
    ImGui::EndChild();
}

/// How far the lesson has been read, as a thin bar of as many parts as there are steps.
void draw_progress(const Theme& theme, const LessonPlayer& lesson_player) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const auto steps = static_cast<float>(lesson_player.lesson()->steps.size());
    const float between = theme.px(3);
    const float part = (width - between * (steps - 1)) / steps;
    const float height = theme.px(3);
    for (std::size_t k = 0; k < lesson_player.lesson()->steps.size(); ++k) {
        const float x = std::floor(corner.x + static_cast<float>(k) * (part + between));
        ImGui::GetWindowDrawList()->AddRectFilled(
            {x, corner.y}, {std::floor(x + part), corner.y + height},
            k <= lesson_player.place() ? theme.palette.accent : theme.palette.frame);
    }
    ImGui::Dummy({width, height});
}

/// To the next step; from the last one to the next lesson, and from the last lesson to the list.
void draw_next_button(PanelContext& context, LessonPlayer& lesson_player) {
    if (!lesson_player.last()) {
        if (button(context, "Next", "lesson-next", -FLT_MIN,
                   {"", "The next step. Its run and view are set up in one go.", "Key: PageDown", "", ""}))
            lesson_player.next(context.client, context.view);
    } else if (const Lesson* next = lesson_player.next_lesson()) {
        if (button(context, "Next lesson", "lesson-next", -FLT_MIN, {next->title, next->summary, "", "", ""}))
            lesson_player.begin(*next, context.client, context.view);
    } else if (button(context, "Finish", "lesson-next", -FLT_MIN,
                      {"", "That was the last step. Back to the list of lessons.", "", "", ""})) {
        lesson_player.leave();
    }
}

void draw_buttons(PanelContext& context, LessonPlayer& lesson_player) {
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap()) / 3);
    ImGui::BeginDisabled(lesson_player.first());
    if (button(context, "Back", "lesson-back", width,
               {"", "The step before. What it shows is set up anew.", "Key: PageUp", "", ""}))
        lesson_player.back(context.client, context.view);
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (button(context, "Show again", "lesson-again", width,
               {"", "Scene, schemes, lanes and view as this step sets them, whatever has been changed since.",
                "", "", ""}))
        lesson_player.show(context.client, context.view);
    ImGui::SameLine();
    const Palette& palette = context.theme.palette;
    ImGui::PushStyleColor(ImGuiCol_Button, palette.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(palette.accent, 0.9f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(palette.accent, 0.8f));
    ImGui::PushStyleColor(ImGuiCol_Text, palette.accent_text);
    draw_next_button(context, lesson_player);
    ImGui::PopStyleColor(4);
}

void draw_step(PanelContext& context, LessonPlayer& lesson_player) {
    const Theme& theme = context.theme;
    const LessonStep& step = lesson_player.step();
    wrapped(theme.small, theme.palette.text_dim, lesson_player.lesson()->title);
    wrapped(theme.title, theme.palette.text, step.title);
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float below = ImGui::GetFrameHeight() + theme.px(3) + 2 * spacing;
    ImGui::BeginChild("lesson-text", {0, -below});
    if (lesson_player.take_turned()) ImGui::SetScrollY(0);
    draw_blocks(theme, context.backgrounds, step.text);
    if (!step.tries.empty()) {
        ImGui::Dummy({0, theme.px(2)});
        ImGui::Separator();
        ImGui::PushFont(theme.bold);
        text(theme.palette.accent, "What to try");
        ImGui::PopFont();
        draw_items(theme, step.tries);
    }
    ImGui::EndChild();
    draw_progress(theme, lesson_player);
    draw_buttons(context, lesson_player);
}

}  // namespace

void draw_lesson_panel(PanelContext& context, LessonPlayer& lesson_player) {
    lesson_player.update(context.client, context.view);
    draw_top(context, lesson_player);
    if (lesson_player.lesson() == nullptr) return draw_list(context, lesson_player);
    draw_step(context, lesson_player);
}

}  // namespace whorl::app
