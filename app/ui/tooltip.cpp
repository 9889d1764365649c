#include "app/ui/tooltip.h"

#include <imgui.h>

#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

constexpr double patience = 0.35;  // seconds

void line(ImU32 colour, std::string_view text) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

}  // namespace

void Tooltip::item(const Theme& theme, std::string_view key, const TooltipText& help) {
    if (on_item) on_item(key, help);
    if (ImGui::IsItemActive()) return;
    // A row's label stands for its control.
    const bool on_label = on_row_label();
    if (!on_label && !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    seen_ = true;
    if (hovered_ != key) {
        hovered_ = key;
        since_ = ImGui::GetTime();
    }
    if (ImGui::GetTime() - since_ < patience) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(12), theme.px(9)));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme.px(320));
    if (!help.title.empty()) {
        ImGui::PushFont(theme.bold);
        line(theme.palette.text, help.title);
        ImGui::PopFont();
    }
    line(theme.palette.accent, help.warning);
    line(theme.palette.text, help.text);
    ImGui::PushFont(theme.small);
    line(theme.palette.text_dim, help.source);
    line(theme.palette.text_dim, help.detail);
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

void Tooltip::end_frame() {
    if (!seen_) hovered_.clear();
    seen_ = false;
}

}  // namespace whorl::app
