#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/charts/charts.h"
#include "app/charts/measure_tabs.h"
#include "app/ui/widgets.h"
#include "app/views/views.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

/// A line of a chart, of whichever lane.
struct Line {
    std::string label;
    int colour;  ///< place in the palette
    std::span<const float> x, y;
};

bool wanted(const Chart& chart, const SessionSnapshot& session) {
    switch (chart.needs()) {
        case Needs::Reference:
            return has_errors(session);
        case Needs::LimiterMasks:
            return std::any_of(session.lanes.begin(), session.lanes.end(),
                               [](const Snapshot& lane) { return lane.limits.has_value(); });
        case Needs::SolvedFlow:
            return std::any_of(session.lanes.begin(), session.lanes.end(), is_solved);
        case Needs::Nothing:
            break;
    }
    return true;
}

std::vector<Chart> charts_for(const SessionSnapshot& session, const MeasureView& view) {
    std::vector<Chart> charts =
        session.lanes.size() == 1 ? charts_of(Page::Plots) : lanes_charts_of(Page::Plots, *view.norm);
    std::erase_if(charts, [&](const Chart& chart) { return !wanted(chart, session); });
    return charts;
}

std::vector<Line> lines_of(const Chart& chart, const History& history, const SessionSnapshot& session,
                           const LaneNames& names) {
    std::vector<Line> lines;
    if (session.lanes.size() == 1) {
        const LaneHistory& lane = history.lane(session.ids.front());
        for (const Measure* measure : chart.curves)
            lines.push_back({measure->label(), measure->plot.colour, lane.steps, lane.of(*measure)});
        return lines;
    }
    for (std::size_t k = 0; k < session.lanes.size(); ++k) {
        const LaneHistory& lane = history.lane(session.ids[k]);
        lines.push_back({names.name(k), static_cast<int>(k), lane.steps, lane.of(chart.first())});
    }
    return lines;
}

/// The interval of y with at least these two values in it, and air around.
Interval around(const std::vector<float>& y, double low, double high) {
    const auto [least, most] = std::minmax_element(y.begin(), y.end());
    const double lo = std::min(low, static_cast<double>(*least));
    const double hi = std::max(high, static_cast<double>(*most));
    const double air = 0.08 * (hi - lo);
    return {lo - air, hi + air};
}

/// Shares of smoke and densities get a scale that does not blow up rounding; times one that a factorisation
/// now and then does not flatten.
std::optional<Interval> range_of(const Chart& chart, const std::vector<Line>& lines) {
    const Scale scale = chart.scale();
    if (scale == Scale::Fitted || scale == Scale::Logarithmic) return {};
    std::vector<float> known;
    for (const Line& line : lines) {
        std::copy_if(line.y.begin(), line.y.end(), std::back_inserter(known),
                     [](float y) { return std::isfinite(y); });
        if (scale == Scale::Milliseconds && chart.curves.size() > 1) break;  // the total
    }
    if (known.empty()) return {};
    if (scale == Scale::Percent) return around(known, 99, 101);
    if (scale == Scale::Density) return around(known, 0, 0.05);
    const auto high = known.begin() + static_cast<long>(0.98 * static_cast<double>(known.size()));
    std::nth_element(known.begin(), high, known.end());
    if (*high > 0) return Interval{0, 1.4 * static_cast<double>(*high)};
    return {};
}

class PlotsTab final : public Tab {
  public:
    PlotsTab(Ui& ui, const RunView& run, const History& history, const FrameLog& frames, MeasureView& view)
        : ui_(ui), run_(run), history_(history), frames_(frames), view_(view) {}

    void draw() override {
        const Theme& theme = ui_.theme;
        const SessionSnapshot& session = run_.session();
        if (session.lanes.size() > 1 && has_errors(session)) norm_chips();
        const std::vector<Chart> charts = charts_for(session, view_);
        const float gap = ImGui::GetStyle().ItemSpacing.y;
        const float room = ImGui::GetContentRegionAvail().y / static_cast<float>(charts.size() + 1) - gap;
        const float height = std::floor(std::clamp(room, theme.px(118), theme.px(320)));
        std::optional<double> hovered;
        for (const Chart& chart : charts) {
            const auto x = draw_chart(chart, height);
            ui_.log.control("plot=" + chart.key);
            if (x) hovered = x;
        }
        if (!frames_.intervals().empty()) draw_frame_time(height);
        view_.marker = hovered;
    }

  private:
    std::optional<double> draw_chart(const Chart& chart, float height) {
        const SessionSnapshot& session = run_.session();
        const std::vector<Line> lines = lines_of(chart, history_, session, run_.names());
        std::vector<Series> series;
        for (const Line& line : lines) {
            Series one{line.label, ui_.theme.lane(line.colour), line.y};
            one.x = line.x;
            series.push_back(one);
        }
        const std::string unit = chart.unit();
        Plot plot;
        plot.title = chart.title;
        plot.unit = unit;
        plot.legend = session.lanes.size() == 1;
        plot.log_y = chart.scale() == Scale::Logarithmic;
        plot.y_range = range_of(chart, lines);
        plot.marker = view_.marker;
        if (chart.needs() == Needs::Reference) plot.empty_text = "nothing to compare with so far";
        plot.size = {0, height};
        return draw_on_card(ui_, plot, series);
    }

    void norm_chips() {
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        row_label(ui_.theme, "Error norm");
        std::vector<const Measure*> norms;
        for (const Measure* measure : measures().all()) {
            if (measure->needs == Needs::Reference && measure->plot.page == Page::Plots)
                norms.push_back(measure);
        }
        const auto count = static_cast<float>(norms.size());
        const float width = std::floor((ImGui::GetContentRegionAvail().x - (count - 1) * gap) / count);
        for (const Measure* norm : norms) {
            if (norm != norms.front()) ImGui::SameLine();
            if (chip(ui_.theme, norm->label().c_str(), view_.norm == norm, width)) view_.norm = norm;
            const std::string key = "norm=" + norm->label();
            ui_.log.control(key);
            ui_.tooltip.item(ui_.theme, key,
                             {"Error norm",
                              "Which error the lanes are compared by: L1 the mean, L2 the root of the mean "
                              "square, L∞ the largest.",
                              "", "thesis eq. 5.4, 5.6, 5.7", ""});
        }
    }

    void draw_frame_time(float height) {
        const FrameLog& frames = frames_;
        char title[48];
        std::snprintf(title, sizeof title, "Frame time · %.0f fps", frames.frames_per_second());
        Plot plot;
        plot.title = title;
        plot.unit = "ms";
        plot.x_name = "frame";
        plot.x_first = static_cast<double>(frames.first());
        plot.y_range =
            Interval{0, std::max(25.0, 1.1 * static_cast<double>(*std::max_element(
                                                 frames.intervals().begin(), frames.intervals().end())))};
        plot.size = {0, height};
        const auto& colours = ui_.theme.palette.series;
        const Series series[] = {{"frame", colours[0], frames.intervals()},
                                 {"busy", colours[1], frames.work()}};
        draw_on_card(ui_, plot, series);
        ui_.log.control("plot=frame-time");
    }

    Ui& ui_;
    const RunView& run_;
    const History& history_;
    const FrameLog& frames_;
    MeasureView& view_;
};

}  // namespace

bool has_errors(const SessionSnapshot& session) {
    return session.setup.reference != no_reference ||
           experiment(session.setup.scene.experiment).exact != nullptr;
}

std::optional<double> draw_on_card(Ui& ui, const Plot& plot, std::span<const Series> series) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + ImGui::GetContentRegionAvail().x, low.y + plot.size.y};
    ui.backgrounds.add(*ImGui::GetWindowDrawList(), low, high, ui.theme.px(5), ui.theme.palette.card);
    Theme bare = ui.theme;
    bare.palette.card = 0;
    return draw_plot(bare, plot, series);
}

std::vector<SheetPlot> plots_of(const History& history, const SessionSnapshot& session,
                                const MeasureView& view) {
    LaneNames names;
    names.update(session.setup);
    std::vector<SheetPlot> plots;
    for (const Chart& chart : charts_for(session, view)) {
        if (chart.first().timing) continue;
        SheetPlot plot;
        plot.title = chart.title;
        plot.unit = chart.unit();
        plot.log_y = chart.scale() == Scale::Logarithmic;
        for (const Line& line : lines_of(chart, history, session, names)) {
            const auto until =
                std::upper_bound(line.x.begin(), line.x.end(), static_cast<float>(session.step));
            const auto count = until - line.x.begin();
            plot.curves.push_back(
                {line.label, line.colour, {line.x.begin(), until}, {line.y.begin(), line.y.begin() + count}});
        }
        plots.push_back(std::move(plot));
    }
    return plots;
}

std::unique_ptr<Tab> make_plots_tab(Ui& ui, const RunView& run, const History& history,
                                    const FrameLog& frames, MeasureView& view) {
    return std::make_unique<PlotsTab>(ui, run, history, frames, view);
}

}  // namespace whorl::app
