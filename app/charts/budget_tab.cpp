#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/charts/charts.h"
#include "app/charts/measure_tabs.h"
#include "app/plot/stack_plot.h"
#include "app/ui/widgets.h"
#include "app/views/views.h"

namespace whorl::app {
namespace {

/// "a, b and c" of the legend.
std::string phases_of(const Chart& chart) {
    std::string text;
    for (auto measure = chart.curves.rbegin(); measure != chart.curves.rend(); ++measure) {
        if (!text.empty()) text += std::next(measure) == chart.curves.rend() ? " and " : ", ";
        text += (*measure)->label();
    }
    return text;
}

class BudgetTab final : public Tab {
  public:
    BudgetTab(Ui& ui, const RunView& run, const History& history, MeasureView& view)
        : ui_(ui), run_(run), history_(history), view_(view) {}

    void draw() override {
        const Theme& theme = ui_.theme;
        const std::vector<Chart> budgets = charts_of(Page::BudgetShares);
        const std::vector<Chart> charts = lanes_charts_of(Page::Budget, *view_.norm);
        quantity_chips(budgets);
        const float note = 4 * theme.small->FontSize;
        const float room = ImGui::GetContentRegionAvail().y - note - 3 * ImGui::GetStyle().ItemSpacing.y;
        const float share = room / static_cast<float>(1 + charts.size());
        const float height = std::floor(std::clamp(share, theme.px(150), theme.px(340)));
        auto hovered = draw_budget(budgets[view_.budget], height);
        for (const Chart& chart : charts) {
            const auto x = draw_lanes(chart, height);
            if (!hovered) hovered = x;
        }
        view_.marker = hovered;
        ImGui::PushFont(theme.small);
        ImGui::PushTextWrapPos(0);
        text(
            theme.palette.text_dim,
            "The ν for which ν · 2 · enstrophy is the energy that advection took, a time. Below 0 the scheme "
            "gave "
            "energy.");
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }

  private:
    void quantity_chips(const std::vector<Chart>& budgets) {
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const auto count = static_cast<float>(budgets.size());
        const float width = std::floor((ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count);
        for (std::size_t k = 0; k < budgets.size(); ++k) {
            const Chart& budget = budgets[k];
            if (k > 0) ImGui::SameLine();
            if (chip(ui_.theme, budget.title.c_str(), view_.budget == k, width)) view_.budget = k;
            const std::string key = "budget=" + budget.title;
            ui_.log.control(key);
            const std::string help =
                "How much " + budget.first().plot.shared + ", " + phases_of(budget) +
                " gave or took in each step. What advection takes is numerical dissipation.";
            ui_.tooltip.item(ui_.theme, key, {budget.title + " budget", help, "", "", ""});
        }
    }

    std::optional<double> draw_budget(const Chart& budget, float height) {
        const Theme& theme = ui_.theme;
        const SessionSnapshot& session = run_.session();
        const std::size_t place = run_.selected();
        const LaneHistory& lane = history_.lane(session.ids[place]);
        std::vector<Series> parts;
        for (auto measure = budget.curves.rbegin(); measure != budget.curves.rend(); ++measure) {
            const Plotting& plot = (*measure)->plot;
            Series part{(*measure)->label(), theme.lane(plot.colour), lane.of(**measure)};
            part.x = lane.steps;
            parts.push_back(part);
        }
        const std::string& name = run_.names().name(place);
        const std::string title =
            budget.title + " a step" + (session.lanes.size() > 1 ? " · " + name : std::string());
        Plot plot;
        plot.title = title;
        plot.marker = view_.marker;
        plot.size = {0, height};
        if (!is_solved(session.lanes[place])) plot.empty_text = "the flow is given, not solved for";
        const ImVec2 low = ImGui::GetCursorScreenPos();
        ui_.backgrounds.add(*ImGui::GetWindowDrawList(), low,
                            {low.x + ImGui::GetContentRegionAvail().x, low.y + height}, theme.px(5),
                            theme.palette.card);
        Theme bare = theme;
        bare.palette.card = 0;
        const auto x = draw_stack(bare, plot, parts, "net");
        ui_.log.control("plot=budget");
        return x;
    }

    std::optional<double> draw_lanes(const Chart& chart, float height) {
        const SessionSnapshot& session = run_.session();
        std::vector<Series> series;
        for (std::size_t k = 0; k < session.lanes.size(); ++k) {
            const LaneHistory& lane = history_.lane(session.ids[k]);
            Series one{run_.names().name(k), ui_.theme.lane(static_cast<int>(k)), lane.of(chart.first())};
            one.x = lane.steps;
            series.push_back(one);
        }
        const std::string unit = chart.unit();
        Plot plot;
        plot.title = chart.title;
        plot.unit = unit;
        plot.legend = false;
        plot.marker = view_.marker;
        plot.size = {0, height};
        plot.empty_text =
            is_solved(run_.snapshot()) ? "still air so far" : "the flow is given, not solved for";
        const auto x = draw_on_card(ui_, plot, series);
        ui_.log.control("plot=" + chart.key);
        return x;
    }

    Ui& ui_;
    const RunView& run_;
    const History& history_;
    MeasureView& view_;
};

}  // namespace

std::unique_ptr<Tab> make_budget_tab(Ui& ui, const RunView& run, const History& history, MeasureView& view) {
    return std::make_unique<BudgetTab>(ui, run, history, view);
}

}  // namespace whorl::app
