#include "app/ui/ui.h"

#include <imgui.h>

#include <cmath>
#include <string>

namespace whorl::app {
namespace {

bool disables(const TooltipText& help) {
    return !help.warning.empty();
}

}  // namespace

void Ui::explain(std::string_view key, const TooltipText& help) {
    log.control(key);
    tooltip.item(theme, key, help);
}

bool Ui::button(const char* label, std::string_view key, float width, const TooltipText& help, bool enabled) {
    ImGui::BeginDisabled(!enabled || disables(help));
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::EndDisabled();
    explain(key, help);
    return pressed;
}

bool Ui::accent_button(const char* label, std::string_view key, float width, const TooltipText& help) {
    const Palette& palette = theme.palette;
    ImGui::PushStyleColor(ImGuiCol_Button, palette.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(palette.accent, 0.9f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(palette.accent, 0.8f));
    ImGui::PushStyleColor(ImGuiCol_Text, palette.accent_text);
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::PopStyleColor(4);
    explain(key, help);
    return pressed;
}

bool Ui::chip(const char* label, std::string_view key, bool chosen, float width, const TooltipText& help) {
    ImGui::BeginDisabled(disables(help));
    const bool clicked = app::chip(theme, label, chosen, width);
    ImGui::EndDisabled();
    explain(key, help);
    return clicked;
}

bool Ui::chip_in_row(std::string_view key, bool chosen, float width, bool first, const TooltipText& help) {
    if (!first) ImGui::SameLine(0, std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x));
    const std::string label = fitted(help.title, width) + "##" + std::string(key);
    return chip(label.c_str(), key, chosen, width, help);
}

bool Ui::check(const char* label, std::string_view key, bool value, const TooltipText& help) {
    ImGui::BeginDisabled(disables(help));
    const bool clicked = app::check(label, value);
    ImGui::EndDisabled();
    explain(key, help);
    return clicked;
}

bool Ui::list_item(const char* label, std::string_view key, bool chosen, const TooltipText& help) {
    const bool taken = app::list_item(label, chosen);
    explain(key, help);
    return taken;
}

bool Ui::slider(const char* id, std::string_view key, int& value, SliderRange range,
                const TooltipText& help) {
    ImGui::BeginDisabled(disables(help));
    const bool changed = app::slider(theme, id, value, range, "");
    ImGui::EndDisabled();
    explain(key, help);
    return changed;
}

}  // namespace whorl::app
