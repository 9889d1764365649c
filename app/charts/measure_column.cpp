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

struct TabEntry {
    MeasureTab tab;
    const char* label;
    const char* help;
    std::unique_ptr<Tab> (*make)(const Services&, MeasureView&);
};

constexpr TabEntry entries[] = {
    {MeasureTab::Plots, "Plots", "The measures over steps.",
     [](const Services& s, MeasureView& view) {
         return make_plots_tab(s.ui, s.run, s.history, s.frames, view);
     }},
    {MeasureTab::Spectrum, "Spectrum", "How kinetic energy spreads over wave numbers.",
     [](const Services& s, MeasureView& view) { return make_spectrum_tab(s.ui, s.run, view); }},
    {MeasureTab::Budget, "Budget", "Who gives and takes energy in a step, and the effective viscosity.",
     [](const Services& s, MeasureView& view) { return make_budget_tab(s.ui, s.run, s.history, view); }},
    {MeasureTab::Table, "Table", "The present values of every lane, to sort.",
     [](const Services& s, MeasureView&) { return make_table_tab(s.ui, s.run, s.history); }},
};

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

MeasureColumn::MeasureColumn(const Services& services, MeasureView& view)
    : ui_(services.ui), run_(services.run), right_column_(services.right_column), view_(view) {
    for (const TabEntry& entry : entries) tabs_.push_back(entry.make(services, view));
}

void MeasureColumn::figures_line() {
    const Theme& theme = ui_.theme;
    ImGui::PushFont(theme.mono);
    bool begun = false;
    for (const Measure* measure : measures().all()) {
        const Headline& headline = measure->headline;
        if (headline.symbol.empty()) continue;
        const double value = measure->of(run_.snapshot().measures);
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

void MeasureColumn::lane_legend() {
    const Theme& theme = ui_.theme;
    const SessionSnapshot& session = run_.session();
    ImGui::PushFont(theme.small);
    const float side = theme.px(9);
    const float pad = theme.px(5);
    const float height = ImGui::GetTextLineHeight() + theme.px(6);
    const float left = ImGui::GetCursorScreenPos().x;
    const float right = left + ImGui::GetContentRegionAvail().x;
    ImVec2 at = ImGui::GetCursorScreenPos();
    for (std::size_t k = 0; k < session.lanes.size(); ++k) {
        const std::string title = fitted(run_.names().name(k), right - left - side - 3 * pad);
        const float width = ImGui::CalcTextSize(title.c_str()).x + side + 3 * pad;
        if (at.x > left && at.x + width > right) at = {left, at.y + height + theme.px(2)};
        ImGui::SetCursorScreenPos(at);
        ImGui::PushID(static_cast<int>(k));
        if (ImGui::InvisibleButton("lane", {width, height})) run_.select(k);
        ImGui::PopID();
        const bool selected = run_.selected() == k;
        const bool hovered = ImGui::IsItemHovered();
        const std::string key = "legend-lane=" + std::to_string(k);
        ui_.log.control(key);
        ui_.tooltip.item(
            theme, key,
            {run_.names().name(k), "Click to select the lane: the budget and the figures above are its.", "",
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

void MeasureColumn::tab_chips() {
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    std::vector<const char*> labels;
    for (const TabEntry& tab : entries) labels.push_back(tab.label);
    const std::vector<float> widths = shared_widths(labels, ImGui::GetContentRegionAvail().x, gap);
    for (const TabEntry& tab : entries) {
        if (&tab != entries) ImGui::SameLine(0, gap);
        const bool chosen = view_.tab == tab.tab;
        if (chip(ui_.theme, tab.label, chosen, widths[static_cast<std::size_t>(&tab - entries)]))
            view_.tab = tab.tab;
        const std::string key = "tab=" + std::string(tab.label);
        ui_.log.control(key);
        ui_.tooltip.item(ui_.theme, key, {tab.label, tab.help, "", "", ""});
    }
}

void MeasureColumn::draw() {
    const Theme& theme = ui_.theme;
    ImGui::PushFont(theme.title);
    ImGui::TextUnformatted("Measures");
    ImGui::PopFont();
    const float width = theme.px(84);
    ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
    const bool reading = right_column_.lessons;
    if (ImGui::Button(reading ? "Lesson" : "Lessons", {width, 0})) {
        right_column_.open_lessons();
    }
    ui_.log.control("lessons");
    ui_.tooltip.item(theme, "lessons",
                     {"Lessons", "Walks through what advection does to smoke, and why. Key: L", "", "", ""});
    ImGui::Separator();
    figures_line();
    tab_chips();
    if (run_.session().lanes.size() > 1) lane_legend();
    for (std::size_t k = 0; k < tabs_.size(); ++k) {
        if (view_.tab != entries[k].tab) continue;
        ImGui::BeginChild(entries[k].label, {0, 0}, false, ImGuiWindowFlags_None);
        tabs_[k]->draw();
        ImGui::EndChild();
    }
}

}  // namespace whorl::app
