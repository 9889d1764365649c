#include "app/panels/widgets.h"

#include <imgui.h>

#include <algorithm>

namespace whorl::app {
namespace {

float width_of(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

}  // namespace

float label_width() {
    return std::max(0.40f * ImGui::GetContentRegionAvail().x, 6.0f * ImGui::GetFontSize());
}

void text(ImU32 colour, std::string_view line) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(line.data(), line.data() + line.size());
    ImGui::PopStyleColor();
}

void row_label(const Theme& theme, std::string_view label) {
    const float left = ImGui::GetCursorPosX();
    const float width = label_width();
    ImGui::AlignTextToFramePadding();
    text(theme.palette.text_dim, fitted(label, width - theme.px(4)));
    ImGui::SameLine(left + width);
    ImGui::SetNextItemWidth(-FLT_MIN);
}

std::string fitted(std::string_view line, float width) {
    if (width_of(line) <= width) return std::string(line);
    const float room = width - width_of("…");
    while (!line.empty() && width_of(line) > room) {
        do {
            line.remove_suffix(1);
        } while (!line.empty() && continues(line.back()) && width_of(line) > room);
    }
    while (!line.empty() && continues(line.back())) line.remove_suffix(1);
    if (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0) == 0xc0) line.remove_suffix(1);
    return std::string(line) + "…";
}

bool heading(const Theme& theme, const char* title, bool open_at_first) {
    ImGui::Dummy({0, theme.px(2)});
    ImGui::PushFont(theme.bold);
    ImGui::PushStyleColor(ImGuiCol_HeaderHovered, IM_COL32(255, 255, 255, 10));
    ImGui::PushStyleColor(ImGuiCol_HeaderActive, IM_COL32(255, 255, 255, 18));
    const bool open = ImGui::TreeNodeEx(
        title, ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth |
                   (open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None));
    ImGui::PopStyleColor(2);
    ImGui::PopFont();
    return open;
}

bool chip(const Theme& theme, const char* label, bool chosen, float width) {
    const Palette& p = theme.palette;
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? p.accent : p.frame);
    if (chosen) {
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, p.accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, p.accent);
        ImGui::PushStyleColor(ImGuiCol_Text, p.accent_text);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(2), ImGui::GetStyle().FramePadding.y));
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(chosen ? 4 : 1);
    return pressed;
}

bool check(const char* label, bool value) {
    return ImGui::Checkbox(label, &value);
}

}  // namespace whorl::app
