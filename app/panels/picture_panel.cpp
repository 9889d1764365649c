// Pictures, animations and tables of the run.
#include <imgui.h>

#include <cmath>
#include <cstdio>

#include "app/panels/panel.h"
#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

void size_row(PanelContext& context) {
    constexpr int scales[] = {1, 2, 4};
    row_label(context.theme, "Size");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    for (const int scale : scales) {
        if (scale != scales[0]) ImGui::SameLine();
        const std::string label = std::to_string(scale) + "×";
        if (chip(context.theme, label.c_str(), context.files.picture.scale == scale, width))
            context.files.picture.scale = scale;
        const std::string key = "picture-size=" + std::to_string(scale);
        context.log.control(key);
        context.tooltip.item(context.theme, key,
                             {"Size of pictures",
                              "Pixels to a point: everything grows with it, lines and letters "
                              "too. 4× is for posters, and takes a moment.",
                              "", "", ""});
    }
}

void paper_row(PanelContext& context) {
    row_label(context.theme, "Paper");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    bool& light = context.files.picture.light;
    if (chip(context.theme, "Dark", !light, width)) light = false;
    context.log.control("picture=dark");
    context.tooltip.item(context.theme, "picture=dark",
                         {"Dark", "Light on dark, as in the window.", "", "", ""});
    ImGui::SameLine();
    if (chip(context.theme, "Light", light, width)) light = true;
    context.log.control("picture=light");
    context.tooltip.item(context.theme, "picture=light", {"Light", "Dark on white, for print.", "", "", ""});
}

void film_row(PanelContext& context) {
    if (!context.files.filming) {
        if (ImGui::Button("Record animation…", {-FLT_MIN, 0})) context.files.ask_film = true;
        context.log.control("film");
        context.tooltip.item(
            context.theme, "film",
            {"Record animation",
             "The run from its start up to now as MP4, GIF or numbered pictures. It is worked "
             "out again beside the window, which goes on.",
             "", "", ""});
        return;
    }
    char line[160];
    std::snprintf(line, sizeof line, "%s · %.0f s", context.files.filming->name.c_str(),
                  context.files.filming->seconds);
    if (ImGui::Button("Cancel")) context.files.cancel_film = true;
    context.log.control("film-cancel");
    context.tooltip.item(context.theme, "film-cancel",
                         {"Cancel the animation", "Stops recording it; nothing of it is left.", "", "", ""});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    text(context.theme.palette.text_dim, fitted(line, ImGui::GetContentRegionAvail().x));
}

}  // namespace

void draw_picture_panel(PanelContext& context) {
    size_row(context);
    paper_row(context);
    bool& plots = context.files.picture.plots;
    if (check("With the plots", plots)) plots = !plots;
    context.log.control("picture-plots");
    context.tooltip.item(context.theme, "picture-plots",
                         {"With the plots", "Puts the measures over steps beneath the fields.", "", "", ""});
    if (ImGui::Button("Take picture", {-FLT_MIN, 0})) context.files.take_picture = true;
    context.log.control("picture");
    context.tooltip.item(
        context.theme, "picture",
        {"Take picture",
         "All that is compared as whorl-0001.png, the next free number, in the folder the program "
         "was started in. The picture carries the run: opening it brings the run back at this "
         "step.",
         "Key: F12", "", ""});
    film_row(context);
    if (ImGui::Button("Save plots as CSV", {-FLT_MIN, 0})) context.files.save_plots = true;
    context.log.control("csv");
    context.tooltip.item(
        context.theme, "csv",
        {"Save plots as CSV",
         "The measures of every lane as whorl-0001.csv, a row a lane and step. Of a long run the "
         "steps that the plots keep.",
         "", "", ""});
}

}  // namespace whorl::app
