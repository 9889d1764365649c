#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/charts/measure_tabs.h"
#include "app/plot/stack_plot.h"
#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

void quantity_chips(PanelContext& context) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
    bool& of_enstrophy = context.measures.of_enstrophy;
    if (chip(context.theme, "Energy", !of_enstrophy, width)) of_enstrophy = false;
    context.log.control("budget=energy");
    context.tooltip.item(
        context.theme, "budget=energy",
        {"Energy budget",
         "How much kinetic energy, ½∫|u|², forces, projection and advection gave or took in each "
         "step. What advection takes is numerical dissipation.",
         "", "", ""});
    ImGui::SameLine();
    if (chip(context.theme, "Enstrophy", of_enstrophy, width)) of_enstrophy = true;
    context.log.control("budget=enstrophy");
    context.tooltip.item(
        context.theme, "budget=enstrophy",
        {"Enstrophy budget",
         "How much enstrophy, ½∫ω², forces, projection and advection gave or took in each step.", "", "",
         ""});
}

std::optional<double> draw_budget(PanelContext& context, float height) {
    const Theme& theme = context.theme;
    const SessionSnapshot& moment = context.client.session();
    const std::size_t place = context.client.selected();
    const LaneHistory& lane = context.history.lane(moment.ids[place]);
    const bool z = context.measures.of_enstrophy;
    const auto& colours = theme.palette.series;
    Series parts[] = {
        {"forces", colours[2], lane.of(z ? Track::EnstrophyByForces : Track::EnergyByForces)},
        {"projection", colours[1], lane.of(z ? Track::EnstrophyByProjection : Track::EnergyByProjection)},
        {"advection", colours[0], lane.of(z ? Track::EnstrophyByAdvection : Track::EnergyByAdvection)}};
    for (Series& part : parts) part.x = lane.steps;
    const std::string& name = context.names.name(place);
    const std::string title = std::string(z ? "Enstrophy" : "Energy") + " a step" +
                              (moment.lanes.size() > 1 ? " · " + name : std::string());
    Plot plot;
    plot.title = title;
    plot.marker = context.measures.marker;
    plot.size = {0, height};
    if (!is_solved(moment.lanes[place])) plot.empty_text = "the flow is given, not solved for";
    const ImVec2 low = ImGui::GetCursorScreenPos();
    context.backgrounds.add(*ImGui::GetWindowDrawList(), low,
                            {low.x + ImGui::GetContentRegionAvail().x, low.y + height}, theme.px(5),
                            theme.palette.card);
    Theme bare = theme;
    bare.palette.card = 0;
    const auto x = draw_stack(bare, plot, parts, "net");
    context.log.control("plot=budget");
    return x;
}

std::optional<double> draw_viscosity(PanelContext& context, float height) {
    const SessionSnapshot& moment = context.client.session();
    std::vector<Series> series;
    for (std::size_t k = 0; k < moment.lanes.size(); ++k) {
        const LaneHistory& lane = context.history.lane(moment.ids[k]);
        Series one{context.names.name(k), context.theme.lane(static_cast<int>(k)),
                   lane.of(Track::EffectiveViscosity)};
        one.x = lane.steps;
        series.push_back(one);
    }
    Plot plot;
    plot.title = "Effective viscosity";
    plot.unit = "length²/time";
    plot.legend = false;
    plot.marker = context.measures.marker;
    plot.size = {0, height};
    plot.empty_text =
        is_solved(context.snapshot()) ? "still air so far" : "the flow is given, not solved for";
    const auto x = draw_on_card(context, plot, series);
    context.log.control("plot=viscosity");
    return x;
}

}  // namespace

void draw_budget_tab(PanelContext& context) {
    const Theme& theme = context.theme;
    quantity_chips(context);
    const float note = 4 * theme.small->FontSize;
    const float room = ImGui::GetContentRegionAvail().y - note - 3 * ImGui::GetStyle().ItemSpacing.y;
    const float height = std::floor(std::clamp(0.5f * room, theme.px(150), theme.px(340)));
    const auto in_budget = draw_budget(context, height);
    const auto in_viscosity = draw_viscosity(context, height);
    context.measures.marker = in_budget ? in_budget : in_viscosity;
    ImGui::PushFont(theme.small);
    ImGui::PushTextWrapPos(0);
    text(theme.palette.text_dim,
         "The ν for which ν · 2 · enstrophy is the energy that advection took, a time. Below 0 the scheme "
         "gave "
         "energy.");
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

}  // namespace whorl::app
