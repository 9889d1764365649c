#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/film/child.h"
#include "app/panels/dialogs.h"
#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

using Kind = FilmOptions::Kind;

void kind_row(PanelContext& context) {
    constexpr std::pair<Kind, const char*> kinds[] = {
        {Kind::Mp4, "MP4"}, {Kind::Gif, "GIF"}, {Kind::Pictures, "PNGs"}};
    constexpr const char* help[] = {"A video. Needs ffmpeg.", "A moving picture for web pages. Needs ffmpeg.",
                                    "A folder of numbered pictures. Needs nothing."};
    row_label(context.theme, "Format");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    for (const auto& [kind, label] : kinds) {
        if (kind != Kind::Mp4) ImGui::SameLine();
        if (chip(context.theme, label, context.files.film.kind == kind, width))
            context.files.film.kind = kind;
        const std::string key = "film=" + std::string(label);
        context.log.control(key);
        context.tooltip.item(context.theme, key, {label, help[static_cast<int>(kind)], "", "", ""});
    }
}

void numbers(PanelContext& context) {
    const Theme& theme = context.theme;
    FilmOptions& film = context.files.film;
    row_label(theme, "Steps a picture");
    slider(theme, "##every", film.every, {1, 20}, "");
    film.every = std::clamp(film.every, 1, 1000);
    context.log.control("film-every");
    context.tooltip.item(theme, "film-every",
                         {"Steps a picture", "Steps from one picture to the next.", "", "", ""});
    ImGui::BeginDisabled(film.kind == Kind::Pictures);
    row_label(theme, "Pictures a second");
    slider(theme, "##fps", film.frames_per_second, {5, 60}, "");
    film.frames_per_second = std::clamp(film.frames_per_second, 1, 60);
    ImGui::EndDisabled();
    context.log.control("film-fps");
    context.tooltip.item(theme, "film-fps",
                         {"Pictures a second", "How fast it plays.", "", "",
                          film.kind == Kind::Pictures ? "Numbered pictures have no speed." : ""});
}

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

void draw_film_dialog(PanelContext& context) {
    const Theme& theme = context.theme;
    FileRequests& files = context.files;
    if (std::exchange(files.ask_film, false)) {
        files.has_ffmpeg = !find_program("ffmpeg").empty();
        if (!files.has_ffmpeg) files.film.kind = Kind::Pictures;
        ImGui::OpenPopup("Record animation");
    }
    if (!begin_dialog(context, "Record animation", 440)) return;
    kind_row(context);
    numbers(context);
    const bool missing = !files.has_ffmpeg && files.film.kind != Kind::Pictures;
    text(missing ? theme.palette.accent : theme.palette.text_dim,
         missing ? "ffmpeg is not installed: only numbered pictures can be made."
                 : length(files.film, context.client.session().step));
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    ImGui::BeginDisabled(missing);
    if (ImGui::Button("Record", {width, 0}) || (files.enter && !missing)) {
        files.make_film = files.film;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndDisabled();
    context.log.control("film-do");
    context.tooltip.item(
        theme, "film-do",
        {"",
         "Works the run out again, beside the window, and writes it into the folder the program "
         "was started in.",
         "Key: Enter", "", ""});
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {width, 0})) ImGui::CloseCurrentPopup();
    context.log.control("film-close");
    context.tooltip.item(theme, "film-close", {"", "Makes no animation.", "Key: Esc", "", ""});
    ImGui::EndPopup();
}

}  // namespace whorl::app
