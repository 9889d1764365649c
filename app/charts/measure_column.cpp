#include "app/charts/measure_column.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/charts/measure_tabs.h"
#include "app/ui/widgets.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

struct Tab {
    MeasureTab tab;
    const char* label;
    const char* help;
    void (*draw)(PanelContext&);
};

constexpr Tab tabs[] = {
    {MeasureTab::Plots, "Plots", "The measures over steps.", draw_plots_tab},
    {MeasureTab::Spectrum, "Spectrum", "How kinetic energy spreads over wave numbers.", draw_spectrum_tab},
    {MeasureTab::Budget, "Budget", "Who gives and takes energy in a step, and the effective viscosity.",
     draw_budget_tab},
    {MeasureTab::Table, "Table", "The present values of every lane, to sort.", draw_table_tab},
};

/// Of the selected lane, as many figures as there is room for.
void figures_line(PanelContext& context) {
    const Theme& theme = context.theme;
    ImGui::PushFont(theme.mono);
    bool begun = false;
    for (const Measure* measure : measures().all()) {
        const Headline& headline = measure->headline;
        if (headline.symbol.empty()) continue;
        const double value = measure->of(context.snapshot().measures);
        const std::string shown = std::isnan(value) ? "–" : figure(value, headline.digits) + headline.unit;
        const std::string line = headline.symbol + " " + shown;
        if (begun) ImGui::SameLine(0, theme.px(18));
        if (begun && ImGui::CalcTextSize(line.c_str()).x > ImGui::GetContentRegionAvail().x) {
            ImGui::NewLine();
            break;
        }
        text(theme.palette.text, line);
        begun = true;
    }
    ImGui::PopFont();
}

/// One legend for all plots: a lane's colour and title; a click selects the lane.
void lane_legend(PanelContext& context) {
    const Theme& theme = context.theme;
    const SessionSnapshot& session = context.client.session();
    ImGui::PushFont(theme.small);
    const float side = theme.px(9);
    const float pad = theme.px(5);
    const float height = ImGui::GetTextLineHeight() + theme.px(6);
    const float left = ImGui::GetCursorScreenPos().x;
    const float right = left + ImGui::GetContentRegionAvail().x;
    ImVec2 at = ImGui::GetCursorScreenPos();
    for (std::size_t k = 0; k < session.lanes.size(); ++k) {
        const std::string title = fitted(context.names.name(k), right - left - side - 3 * pad);
        const float width = ImGui::CalcTextSize(title.c_str()).x + side + 3 * pad;
        if (at.x > left && at.x + width > right) at = {left, at.y + height + theme.px(2)};
        ImGui::SetCursorScreenPos(at);
        ImGui::PushID(static_cast<int>(k));
        if (ImGui::InvisibleButton("lane", {width, height})) context.client.select(k);
        ImGui::PopID();
        const bool selected = context.client.selected() == k;
        const bool hovered = ImGui::IsItemHovered();
        const std::string key = "legend-lane=" + std::to_string(k);
        context.log.control(key);
        context.tooltip.item(
            theme, key,
            {context.names.name(k), "Click to select the lane: the budget and the figures above are its.", "",
             "", session.lanes[k].failure ? "It has stopped." : ""});
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (selected || hovered)
            list.AddRectFilled(at, {at.x + width, at.y + height}, theme.palette.frame, theme.px(4));
        const float middle = at.y + 0.5f * height;
        list.AddRectFilled({at.x + pad, middle - 0.5f * side}, {at.x + pad + side, middle + 0.5f * side},
                           theme.lane(static_cast<int>(k)), theme.px(2));
        list.AddText({at.x + 2 * pad + side, at.y + theme.px(3)},
                     selected ? theme.palette.text : theme.palette.text_dim, title.c_str());
        at.x += width + theme.px(2);
    }
    ImGui::SetCursorScreenPos({left, at.y + height});
    ImGui::Dummy({0, 0});
    ImGui::PopFont();
}

void tab_chips(PanelContext& context) {
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    std::vector<const char*> labels;
    for (const Tab& tab : tabs) labels.push_back(tab.label);
    const std::vector<float> widths = shared_widths(labels, ImGui::GetContentRegionAvail().x, gap);
    for (const Tab& tab : tabs) {
        if (&tab != tabs) ImGui::SameLine(0, gap);
        const bool chosen = context.measures.tab == tab.tab;
        if (chip(context.theme, tab.label, chosen, widths[static_cast<std::size_t>(&tab - tabs)]))
            context.measures.tab = tab.tab;
        const std::string key = "tab=" + std::string(tab.label);
        context.log.control(key);
        context.tooltip.item(context.theme, key, {tab.label, tab.help, "", "", ""});
    }
}

}  // namespace

std::vector<const Measure*> measures_in_sight(MeasureTab tab) {
    std::vector<const Measure*> all;
    for (const Measure* measure : measures().all()) {
        const Page page = measure->plot.page;
        const bool of_budget = page == Page::Budget || page == Page::BudgetShares;
        const bool in_sight =
            (tab == MeasureTab::Plots && page == Page::Plots) || (tab == MeasureTab::Budget && of_budget) ||
            (tab == MeasureTab::Table && !measure->column.group.empty()) || !measure->headline.symbol.empty();
        if (in_sight && measure->row) all.push_back(measure);
    }
    return all;
}

void draw_measure_column(PanelContext& context) {
    const Theme& theme = context.theme;
    ImGui::PushFont(theme.title);
    ImGui::TextUnformatted("Measures");
    ImGui::PopFont();
    const float width = theme.px(84);
    ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
    const bool reading = context.right_column.lessons;
    if (ImGui::Button(reading ? "Lesson" : "Lessons", {width, 0})) {
        context.right_column.open_lessons();
    }
    context.log.control("lessons");
    context.tooltip.item(
        theme, "lessons",
        {"Lessons", "Walks through what advection does to smoke, and why. Key: L", "", "", ""});
    ImGui::Separator();
    figures_line(context);
    tab_chips(context);
    if (context.client.session().lanes.size() > 1) lane_legend(context);
    for (const Tab& tab : tabs) {
        if (context.measures.tab != tab.tab) continue;
        ImGui::BeginChild(tab.label, {0, 0}, false, ImGuiWindowFlags_None);
        tab.draw(context);
        ImGui::EndChild();
    }
}

}  // namespace whorl::app
