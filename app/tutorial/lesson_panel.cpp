#include "app/tutorial/lesson_panel.h"

#include <imgui.h>

#include <cmath>

#include "app/ui/wrapped_text.h"

namespace whorl::app {
namespace {

float gap() {
    return ImGui::GetStyle().ItemSpacing.x;
}

void wrapped(ImFont* font, ImU32 colour, std::string_view line, float margin = 0) {
    ImGui::PushFont(font);
    draw_wrapped(colour, line, margin);
    ImGui::PopFont();
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

}  // namespace

void LessonPanel::draw() {
    player_.update();
    draw_top();
    if (player_.lesson() == nullptr) return draw_list();
    draw_step();
}

void LessonPanel::draw_top() {
    const Theme& theme = ui_.theme;
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(theme.bold);
    const bool reading = player_.lesson() != nullptr;
    const std::string place = reading ? "Step " + std::to_string(player_.place() + 1) + " of " +
                                            std::to_string(player_.lesson()->steps.size())
                                      : "Lessons";
    text(theme.palette.text, place);
    ImGui::PopFont();
    const float width = theme.px(56);
    const float taken = reading ? 3 * width + 2 * gap() : width;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - taken);
    if (reading) {
        if (ui_.button(
                "Plots", "lesson-plots", width,
                {"", "The measures in the lesson's place. Lesson there, or L, comes back.", "", "", ""}))
            column_.shows_measures = true;
        ImGui::SameLine();
        if (ui_.button("All", "lesson-all", width, {"", "The list of lessons.", "", "", ""})) player_.leave();
        ImGui::SameLine();
    }
    if (ui_.button("Close", "lesson-close", width,
                   {"",
                    player_.keeps_run()
                        ? "Closes the lessons and brings back the run that was here before, as it stood."
                        : "Closes the lessons. The run stays as it is.",
                    "Key: L", "", ""}))
        player_.set_open(false);
    ImGui::Separator();
}

void LessonPanel::draw_entry(const Lesson& lesson, int number) {
    const Theme& theme = ui_.theme;
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
    if (ImGui::InvisibleButton(key.c_str(), {width, height})) player_.begin(lesson);
    const std::string steps = std::to_string(lesson.steps.size()) + " steps";
    ui_.explain(key, {lesson.title, lesson.summary, steps, "", ""});
    list.ChannelsSetCurrent(0);
    list.AddRectFilled(corner, {corner.x + width, corner.y + height},
                       ImGui::IsItemHovered() ? theme.palette.frame : theme.palette.card, theme.px(5));
    list.ChannelsMerge();
    ImGui::SetCursorScreenPos(after);
}

void LessonPanel::draw_list() {
    ImGui::BeginChild("lesson-list");
    int number = 0;
    for (const Lesson& lesson : lessons()) draw_entry(lesson, ++number);
    if (player_.own() != nullptr) draw_entry(*player_.own(), ++number);
    ImGui::EndChild();
}

void LessonPanel::draw_next_button() {
    if (!player_.last()) {
        if (ui_.accent_button(
                "Next", "lesson-next", -FLT_MIN,
                {"", "The next step. Its run and view are set up in one go.", "Key: PageDown", "", ""}))
            player_.next();
    } else if (const Lesson* next = player_.next_lesson()) {
        if (ui_.accent_button("Next lesson", "lesson-next", -FLT_MIN,
                              {next->title, next->summary, "", "", ""}))
            player_.begin(*next);
    } else if (ui_.accent_button("Finish", "lesson-next", -FLT_MIN,
                                 {"", "That was the last step. Back to the list of lessons.", "", "", ""})) {
        player_.leave();
    }
}

void LessonPanel::draw_buttons() {
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap()) / 3);
    if (ui_.button("Back", "lesson-back", width,
                   {"", "The step before. What it shows is set up anew.", "Key: PageUp", "", ""},
                   !player_.first()))
        player_.back();
    ImGui::SameLine();
    if (ui_.button(
            "Show again", "lesson-again", width,
            {"", "Scene, schemes, lanes and view as this step sets them, whatever has been changed since.",
             "", "", ""}))
        player_.show();
    ImGui::SameLine();
    draw_next_button();
}

void LessonPanel::draw_step() {
    const Theme& theme = ui_.theme;
    const LessonStep& step = player_.step();
    wrapped(theme.small, theme.palette.text_dim, player_.lesson()->title);
    wrapped(theme.title, theme.palette.text, step.title);
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float below = ImGui::GetFrameHeight() + theme.px(3) + 2 * spacing;
    ImGui::BeginChild("lesson-text", {0, -below});
    if (player_.take_turned()) ImGui::SetScrollY(0);
    draw_blocks(theme, ui_.backgrounds, step.text);
    if (!step.tries.empty()) {
        ImGui::Dummy({0, theme.px(2)});
        ImGui::Separator();
        ImGui::PushFont(theme.bold);
        text(theme.palette.accent, "What to try");
        ImGui::PopFont();
        draw_items(theme, step.tries);
    }
    ImGui::EndChild();
    draw_progress(theme, player_);
    draw_buttons();
}

}  // namespace whorl::app
