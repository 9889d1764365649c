// What of the run is on screen, and in which colours.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/panel.h"
#include "app/ui/widgets.h"
#include "core/experiments/experiment.h"

namespace whorl::app {

namespace {

void view_chips(PanelContext& context) {
    const int columns = ImGui::GetContentRegionAvail().x > context.theme.px(290) ? 3 : 2;
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    const float width =
        std::floor((ImGui::GetContentRegionAvail().x - static_cast<float>(columns - 1) * gap) /
                   static_cast<float>(columns));
    int k = 0;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
    for (const View* each : views()) {
        const View& view = *each;
        const bool known = available(view, context.snapshot());
        if (!known && experiment(context.scene().experiment).exact == nullptr) continue;
        if (k++ % columns != 0) ImGui::SameLine();
        ImGui::BeginDisabled(!known);
        const std::string label = fitted(view.label, width) + "##" + std::string(view.key);
        if (chip(context.theme, label.c_str(), context.view.shown == &view, width)) {
            context.view.shown = &view;
        }
        ImGui::EndDisabled();
        const std::string key = "view=" + std::string(view.key);
        context.log.control(key);
        context.tooltip.item(context.theme, key,
                             {view.label, view.help, view.unit, "",
                              known ? "" : "The exact solution is not known at this time."});
    }
    ImGui::PopStyleVar();
}

void map_list(PanelContext& context) {
    row_label(context.theme, "Colours");
    const ColourMap& chosen = context.view.map();
    if (ImGui::BeginCombo("##map", std::string(chosen.label).c_str())) {
        for (const ColourMap& map : colour_maps()) {
            if (map.kind != chosen.kind) continue;
            if (list_item(std::string(map.label).c_str(), map.key == chosen.key)) {
                context.view.choose(map);
            }
            const std::string key = "map=" + std::string(map.key);
            context.log.control(key);
            context.tooltip.item(
                context.theme, key,
                {map.label,
                 map.kind == ColourMap::Kind::Diverging ? "From one hue over the neutral value to another."
                                                        : "From the least value to the greatest.",
                 "", "", ""});
        }
        ImGui::EndCombo();
    }
    context.log.control("map");
    context.tooltip.item(
        context.theme, "map",
        {"Colours", "Diverging maps for what has a neutral value, sequential ones otherwise.", "", "", ""});
}

void range(PanelContext& context) {
    ColourRange& range = context.view.range;
    if (check("Hold the range", range.held())) range.hold(!range.held());
    context.log.control("hold-range");
    context.tooltip.item(
        context.theme, "hold-range",
        {"Hold the range", "Otherwise the colour bar follows the least and greatest value.", "", "", ""});
    row_label(context.theme, "Range");
    ImGui::BeginDisabled(!range.held());
    float ends[2] = {range.ends().lo, range.ends().hi};
    const float speed = std::max(1e-6f, 0.005f * (ends[1] - ends[0]));
    if (ImGui::DragFloat2("##range", ends, speed, 0, 0, "%.4g")) range.set({ends[0], ends[1]});
    ImGui::EndDisabled();
    context.tooltip.item(context.theme, "range",
                         {"Range", "Values at the ends of the colour bar.", "Drag, or Ctrl+click to type", "",
                          range.held() ? "" : "The range follows the field; hold it to set it."});
}

}  // namespace

void draw_view_panel(PanelContext& context) {
    view_chips(context);
    map_list(context);
    range(context);
    const float left = ImGui::GetCursorPosX();
    const float half = 0.5f * ImGui::GetContentRegionAvail().x;
    if (check("Crisp pixels", context.view.crisp)) context.view.crisp = !context.view.crisp;
    context.log.control("crisp");
    context.tooltip.item(
        context.theme, "crisp",
        {"Crisp pixels", "Squares of one value each; otherwise smooth between the cells.", "", "", ""});
    ImGui::SameLine(left + half);
    if (check("Arrows", context.view.arrows)) context.view.arrows = !context.view.arrows;
    context.log.control("arrows");
    context.tooltip.item(context.theme, "arrows", {"Arrows", "The velocity, over the field.", "", "", ""});
    const bool looked_at = context.view.shown->of_limiters;
    ImGui::BeginDisabled(looked_at);
    if (check("Count limited nodes", context.view.count_limited || looked_at))
        context.view.count_limited = !context.view.count_limited;
    ImGui::EndDisabled();
    context.log.control("count-limited");
    context.tooltip.item(
        context.theme, "count-limited",
        {"Count limited nodes",
         "A plot of how many nodes a limiter or a clamped interpolation changed in each step. Costs "
         "two to seven more advections in every step.",
         "", "thesis sec. 3.2", looked_at ? "The chosen view counts them already." : ""});
}

}  // namespace whorl::app
