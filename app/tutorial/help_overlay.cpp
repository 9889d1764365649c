#include "app/tutorial/help_overlay.h"

#include <imgui.h>

namespace whorl::app {
namespace {

void rows(const Theme& theme, const char* title, std::span<const KeyHelp> table) {
    ImGui::PushFont(theme.bold);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    const float left = ImGui::GetCursorPosX();
    for (const KeyHelp& row : table) {
        text(theme.palette.accent, row.keys);
        ImGui::SameLine(left + theme.px(150));
        ImGui::TextUnformatted(row.what.data(), row.what.data() + row.what.size());
    }
}

}  // namespace

void HelpOverlay::draw(std::span<const KeyHelp> mouse, std::span<const KeyHelp> keys) {
    if (!open) return;
    const Theme& theme = ui_.theme;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(26), theme.px(20)));
    ImGui::Begin("help", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove);
    // All of it fits the least window.
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(8), theme.px(4)));
    rows(theme, "Mouse, over the field", mouse);
    ImGui::Dummy({0, theme.px(6)});
    rows(theme, "Keys", keys);
    ImGui::Dummy({0, theme.px(6)});
    ImGui::Button("Show the tour");
    // A click closes the help wherever it is, before the button would be let go.
    const bool on_tour = ImGui::IsItemHovered();
    ui_.explain("help-tour", {"", "The tour of the first start again.", "", "", ""});
    ImGui::PopStyleVar();
    ImGui::End();
    ImGui::PopStyleVar();
    if (!ImGui::IsMouseClicked(0)) return;
    open = false;
    if (on_tour) tour_.begin();
}

}  // namespace whorl::app
