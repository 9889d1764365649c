#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/panels/dialogs.h"
#include "app/scenes/presets.h"

namespace whorl::app {
namespace {

/// As many files as a person looks through.
constexpr std::size_t most_entries = 500;

}  // namespace

bool begin_dialog(const Theme& theme, FileRequests& files, const char* title, float width) {
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
    files.dialog = true;
    ImGui::PushFont(theme.title);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    if (files.escape) ImGui::CloseCurrentPopup();
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

void OpenDialog::choose() {
    files_.open = path_;
    files_.open_outcome.reset();
    error_.clear();
    opening_ = true;
}

/// Closes the dialog once the path has been opened.
/// @return whether it just turned out that it cannot be opened: another one is typed then
bool OpenDialog::has_failed() {
    if (!opening_ || !files_.open_outcome) return false;
    opening_ = false;
    error_ = *std::exchange(files_.open_outcome, {});
    if (error_.empty()) ImGui::CloseCurrentPopup();
    return !error_.empty();
}

void OpenDialog::list() {
    const Theme& theme = ui_.theme;
    ImGui::BeginChild("entries", {0, theme.px(260)}, true);
    for (const RunEntry& entry : entries_) {
        const bool chosen = path_ == entry.name;
        if (ImGui::Selectable(("##" + entry.name).c_str(), chosen,
                              ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
            path_ = entry.name;
            if (ImGui::IsMouseDoubleClicked(0)) choose();
        }
        const std::string key = "open=" + entry.name;
        ui_.explain(key, {entry.name, entry.title, "Click to choose, double-click to open", "", ""});
        ImGui::SameLine(theme.px(8));
        text(theme.palette.text, entry.name);
        ImGui::SameLine(0, theme.px(12));
        text(theme.palette.text_dim, fitted(entry.title, ImGui::GetContentRegionAvail().x));
    }
    ImGui::EndChild();
}

void OpenDialog::draw() {
    const Theme& theme = ui_.theme;
    if (std::exchange(files_.ask_open, false)) {
        entries_ = runs_here();
        path_.clear();
        error_.clear();
        opening_ = false;
        ImGui::OpenPopup("Open");
    }
    if (!begin_dialog(theme, files_, "Open", 560)) return;
    const bool failed = has_failed();
    text(theme.palette.text_dim, "A preset; a scene, run or lesson (.toml); or a picture of Whorl (.png)");
    list();
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::IsWindowAppearing() || failed) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint("##path", "name or path of a file", &path_)) error_.clear();
    ui_.explain("open-path",
                {"Path", "A preset's name, or the path of a file. Files can also be dropped on the window.",
                 "", "", ""});
    if (!error_.empty()) {
        ImGui::PushTextWrapPos(0);
        text(theme.palette.accent, error_);
        ImGui::PopTextWrapPos();
    }
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    const bool can = !path_.empty() && !opening_;
    const bool pressed = ui_.button(
        "Open", "open-do", width,
        {"", "Begins the preset, the scene or the run in the place of this one.", "Key: Enter", "", ""}, can);
    if (pressed || (files_.enter && can)) choose();
    ImGui::SameLine();
    if (ui_.button("Cancel", "open-cancel", width, {"", "Leaves the run as it is.", "Key: Esc", "", ""}))
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace whorl::app
