// See charts.h.
#include "app/charts/charts.h"

#include <algorithm>

namespace whorl::app {
namespace {

/// Plots that come first; others follow as the list of measures names them, times last.
constexpr std::string_view leading[] = {"Error",     "Total smoke", "Kinetic energy",
                                        "Enstrophy", "Density",     "Limited nodes"};

std::ptrdiff_t rank(const Chart& chart) {
    const auto listed = std::find(std::begin(leading), std::end(leading), chart.key);
    return listed - std::begin(leading) + (chart.first().timing ? 1 : 0);
}

}  // namespace

std::vector<Chart> charts_of(Page page) {
    std::vector<Chart> charts;
    for (const Measure* measure : measures().all()) {
        if (measure->plot.page != page) continue;
        const std::string& name = measure->chart();
        const auto same =
            std::find_if(charts.begin(), charts.end(), [&](const Chart& chart) { return chart.key == name; });
        if (same == charts.end()) {
            charts.push_back({name, name, {measure}});
        } else {
            same->curves.push_back(measure);
        }
    }
    for (Chart& chart : charts) {
        std::stable_sort(chart.curves.begin(), chart.curves.end(),
                         [](const Measure* a, const Measure* b) { return a->plot.colour < b->plot.colour; });
    }
    if (page == Page::Plots)
        std::stable_sort(charts.begin(), charts.end(),
                         [](const Chart& a, const Chart& b) { return rank(a) < rank(b); });
    return charts;
}

std::vector<Chart> lanes_charts_of(Page page, const Measure& norm) {
    std::vector<Chart> charts;
    for (const Chart& chart : charts_of(page)) {
        for (const Measure* measure : chart.curves) {
            const std::string& title = measure->plot.lanes_chart;
            if (measure->needs == Needs::Reference) {
                if (measure == &norm)
                    charts.push_back({chart.key, title.empty() ? chart.title : title, {measure}});
            } else if (!title.empty()) {
                charts.push_back({title, title, {measure}});
            } else if (measure == &chart.first()) {
                charts.push_back({chart.key, chart.title, {measure}});
            }
        }
    }
    return charts;
}

}  // namespace whorl::app
