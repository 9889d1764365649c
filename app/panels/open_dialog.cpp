#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/panels/dialogs.h"
#include "app/scenes/presets.h"
#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

/// As many files as a person looks through.
constexpr std::size_t most_entries = 500;

void choose(PanelContext& context) {
    FileRequests& files = context.files;
    files.open = files.path;
    files.open_outcome.reset();
    files.open_error.clear();
    files.opening = true;
}

/// Closes the dialog once the path has been opened.
/// @return whether it just turned out that it cannot be opened: another one is typed then
bool has_failed(FileRequests& files) {
    if (!files.opening || !files.open_outcome) return false;
    files.opening = false;
    files.open_error = *std::exchange(files.open_outcome, {});
    if (files.open_error.empty()) ImGui::CloseCurrentPopup();
    return !files.open_error.empty();
}

void list(PanelContext& context) {
    const Theme& theme = context.theme;
    FileRequests& files = context.files;
    ImGui::BeginChild("entries", {0, theme.px(260)}, true);
    for (const RunEntry& entry : files.entries) {
        const bool chosen = files.path == entry.name;
        if (ImGui::Selectable(("##" + entry.name).c_str(), chosen,
                              ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
            files.path = entry.name;
            if (ImGui::IsMouseDoubleClicked(0)) choose(context);
        }
        const std::string key = "open=" + entry.name;
        context.log.control(key);
        context.tooltip.item(theme, key,
                             {entry.name, entry.title, "Click to choose, double-click to open", "", ""});
        ImGui::SameLine(theme.px(8));
        text(theme.palette.text, entry.name);
        ImGui::SameLine(0, theme.px(12));
        text(theme.palette.text_dim, fitted(entry.title, ImGui::GetContentRegionAvail().x));
    }
    ImGui::EndChild();
}

}  // namespace

bool begin_dialog(PanelContext& context, const char* title, float width) {
    const Theme& theme = context.theme;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(theme.px(width), screen.x - theme.px(32)), 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(20), theme.px(16)));
    const bool open = ImGui::BeginPopupModal(
        title, nullptr,
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
            ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    if (!open) return false;
    context.files.dialog = true;
    ImGui::PushFont(theme.title);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    if (context.files.escape) ImGui::CloseCurrentPopup();
    return true;
}

std::vector<RunEntry> runs_here() {
    namespace fs = std::filesystem;
    std::vector<RunEntry> entries;
    for (const Preset& preset : presets())
        entries.push_back({std::string(preset.key), preset.scene().title + " · preset"});
    const std::size_t files_from = entries.size();
    std::error_code ignored;
    fs::directory_iterator file(fs::current_path(ignored), ignored);
    for (; file != fs::directory_iterator() && entries.size() < most_entries; file.increment(ignored)) {
        const std::string kind = file->path().extension().string();
        if (!file->is_regular_file(ignored)) continue;
        if (kind == ".toml") entries.push_back({file->path().filename().string(), "scene, run or lesson"});
        if (kind == ".png") entries.push_back({file->path().filename().string(), "picture"});
    }
    std::sort(entries.begin() + static_cast<std::ptrdiff_t>(files_from), entries.end(),
              [](const RunEntry& a, const RunEntry& b) { return a.name < b.name; });
    return entries;
}

void draw_open_dialog(PanelContext& context) {
    const Theme& theme = context.theme;
    FileRequests& files = context.files;
    if (std::exchange(files.ask_open, false)) {
        files.entries = runs_here();
        files.path.clear();
        files.open_error.clear();
        files.opening = false;
        ImGui::OpenPopup("Open");
    }
    if (!begin_dialog(context, "Open", 560)) return;
    const bool failed = has_failed(files);
    text(theme.palette.text_dim, "A preset; a scene, run or lesson (.toml); or a picture of Whorl (.png)");
    list(context);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::IsWindowAppearing() || failed) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint("##path", "name or path of a file", &files.path)) files.open_error.clear();
    context.log.control("open-path");
    context.tooltip.item(
        theme, "open-path",
        {"Path", "A preset's name, or the path of a file. Files can also be dropped on the window.", "", "",
         ""});
    if (!files.open_error.empty()) {
        ImGui::PushTextWrapPos(0);
        text(theme.palette.accent, files.open_error);
        ImGui::PopTextWrapPos();
    }
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    const bool can = !files.path.empty() && !files.opening;
    ImGui::BeginDisabled(!can);
    if (ImGui::Button("Open", {width, 0}) || (files.enter && can)) choose(context);
    ImGui::EndDisabled();
    context.log.control("open-do");
    context.tooltip.item(
        theme, "open-do",
        {"", "Begins the preset, the scene or the run in the place of this one.", "Key: Enter", "", ""});
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {width, 0})) ImGui::CloseCurrentPopup();
    context.log.control("open-cancel");
    context.tooltip.item(theme, "open-cancel", {"", "Leaves the run as it is.", "Key: Esc", "", ""});
    ImGui::EndPopup();
}

}  // namespace whorl::app
