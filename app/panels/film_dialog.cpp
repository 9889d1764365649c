#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/film/child.h"
#include "app/panels/dialogs.h"

namespace whorl::app {
namespace {

using Kind = FilmOptions::Kind;

/// How long it gets.
std::string length(const FilmOptions& film, long steps) {
    const long pictures = steps / film.every + 1;
    char line[96];
    if (film.kind == Kind::Pictures) {
        std::snprintf(line, sizeof line, "Steps 0 to %ld: %ld pictures", steps, pictures);
    } else {
        std::snprintf(line, sizeof line, "Steps 0 to %ld: %ld pictures, %.1f s", steps, pictures,
                      static_cast<double>(pictures) / film.frames_per_second);
    }
    return line;
}

}  // namespace

void FilmDialog::kind_row() {
    constexpr std::pair<Kind, const char*> kinds[] = {
        {Kind::Mp4, "MP4"}, {Kind::Gif, "GIF"}, {Kind::Pictures, "PNGs"}};
    constexpr const char* help[] = {"A video. Needs ffmpeg.", "A moving picture for web pages. Needs ffmpeg.",
                                    "A folder of numbered pictures. Needs nothing."};
    row_label(ui_.theme, "Format");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    for (const auto& [kind, label] : kinds) {
        if (kind != Kind::Mp4) ImGui::SameLine();
        const std::string key = "film=" + std::string(label);
        if (ui_.chip(label, key, files_.film.kind == kind, width,
                     {label, help[static_cast<int>(kind)], "", "", ""}))
            files_.film.kind = kind;
    }
}

void FilmDialog::numbers() {
    FilmOptions& film = files_.film;
    row_label(ui_.theme, "Steps a picture");
    ui_.slider("##every", "film-every", film.every, {1, 20},
               {"Steps a picture", "Steps from one picture to the next.", "", "", ""});
    film.every = std::clamp(film.every, 1, 1000);
    const char* const still = film.kind == Kind::Pictures ? "Numbered pictures have no speed." : "";
    ImGui::BeginDisabled(film.kind == Kind::Pictures);
    row_label(ui_.theme, "Pictures a second");
    ImGui::EndDisabled();
    ui_.slider("##fps", "film-fps", film.frames_per_second, {5, 60},
               {"Pictures a second", "How fast it plays.", "", "", still});
    film.frames_per_second = std::clamp(film.frames_per_second, 1, 60);
}

void FilmDialog::draw() {
    const Theme& theme = ui_.theme;
    if (std::exchange(files_.ask_film, false)) {
        has_ffmpeg_ = !find_program("ffmpeg").empty();
        if (!has_ffmpeg_) files_.film.kind = Kind::Pictures;
        ImGui::OpenPopup("Record animation");
    }
    if (!begin_dialog(theme, files_, "Record animation", 440)) return;
    kind_row();
    numbers();
    const bool missing = !has_ffmpeg_ && files_.film.kind != Kind::Pictures;
    text(missing ? theme.palette.accent : theme.palette.text_dim,
         missing ? "ffmpeg is not installed: only numbered pictures can be made."
                 : length(files_.film, run_.session().step));
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    const bool pressed = ui_.button("Record", "film-do", width,
                                    {"",
                                     "Works the run out again, beside the window, and writes it into the "
                                     "folder the program was started in.",
                                     "Key: Enter", "", ""},
                                    !missing);
    if (pressed || (files_.enter && !missing)) {
        files_.make_film = files_.film;
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ui_.button("Cancel", "film-close", width, {"", "Makes no animation.", "Key: Esc", "", ""}))
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace whorl::app
