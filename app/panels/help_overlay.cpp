#include "app/panels/help_overlay.h"

#include <imgui.h>

#include "app/scenes/presets.h"
#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

struct Row {
    const char* key;
    const char* what;
};

constexpr Row mouse[] = {
    {"Drag", "inject smoke and heat, and pull the fluid along"},
    {"Right-drag", "push the fluid only"},
    {"Shift-drag", "paint an obstacle"},
    {"Ctrl-drag", "erase obstacles"},
    {"Wheel", "radius of the brush"},
    {"Ctrl+wheel, + and -", "closer, and away"},
    {"Middle-drag, Alt-drag", "move what is shown"},
    {"Rest on a control", "what it does, and where it comes from"},
    {"Ctrl+click a slider", "type a value"},
    {"Right-click a control", "back to the value of all lanes"},
    {"Drop a file", "open a scene, a run, a lesson or a picture"},
};
void rows(const Theme& theme, const char* title, std::span<const Row> table) {
    ImGui::PushFont(theme.bold);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    const float left = ImGui::GetCursorPosX();
    for (const Row& row : table) {
        text(theme.palette.accent, row.key);
        ImGui::SameLine(left + theme.px(150));
        ImGui::TextUnformatted(row.what);
    }
}

}  // namespace

void draw_help_overlay(PanelContext& context) {
    if (!context.view.help) return;
    const Theme& theme = context.theme;
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
    const std::string digits = "1 – " + std::to_string(presets().size());
    const Row keys[] = {
        {"Space", "play, pause"},
        {".", "one step"},
        {"R", "reset"},
        {"← →", "a step back, a step on"},
        {"Home, End", "the run's first and last step"},
        {digits.c_str(), "presets"},
        {"0", "the whole domain"},
        {"Tab", "hold: the other lane, where one is shown"},
        {"Ctrl+O", "open a scene, a run or a picture"},
        {"Ctrl+S", "save the run"},
        {"I", "inspector: click a cell; Shift+arrow goes on"},
        {"L", "lessons; Page Up and Down turn their steps"},
        {"F12", "picture as PNG, which carries the run"},
        {"H", "this help"},
        {"Esc", "close this, a dialog or the top lab"},
        {"Q, Ctrl+Q", "quit"},
    };
    rows(theme, "Keys", keys);
    ImGui::Dummy({0, theme.px(6)});
    ImGui::Button("Show the tour");
    // A click closes the help wherever it is, before the button would be let go.
    const bool on_tour = ImGui::IsItemHovered();
    context.log.control("help-tour");
    context.tooltip.item(theme, "help-tour", {"", "The tour of the first start again.", "", "", ""});
    ImGui::PopStyleVar();
    ImGui::End();
    ImGui::PopStyleVar();
    if (!ImGui::IsMouseClicked(0)) return;
    context.view.help = false;
    if (on_tour) context.view.tour.begin();
}

}  // namespace whorl::app
