#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/charts/measure_tabs.h"
#include "app/ui/widgets.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

/// A curve of a chart.
struct Curve {
    const char* label;
    Track track;
};

/// A plot of the run's history.
struct Chart {
    /// A flow that is solved for; something to compare with; limiters that are watched.
    enum class When { Always, Solved, Errors, Limiters };
    enum class Scale { Fitted, Logarithmic, Percent, Density, Milliseconds };

    const char* title;
    const char* unit;
    Scale scale;
    When when;
    std::span<const Curve> curves;  ///< of one lane; of several lanes the first is shown of each
};

constexpr Curve total[] = {{"of what was put in", Track::DensityPercent}};
constexpr Curve error[] = {{"L1", Track::L1}, {"L2", Track::L2}, {"L∞", Track::Linf}};
constexpr Curve energy[] = {{"½∫|u|²", Track::KineticEnergy}};
constexpr Curve enstrophy[] = {{"½∫ω²", Track::Enstrophy}};
constexpr Curve extrema[] = {{"max", Track::MaxDensity}, {"min", Track::MinDensity}};
constexpr Curve largest[] = {{"max", Track::MaxDensity}};
constexpr Curve smallest[] = {{"min", Track::MinDensity}};
constexpr Curve limited[] = {{"smoke", Track::LimitedDensity}, {"velocity", Track::LimitedVelocity}};
constexpr Curve divergence[] = {{"after", Track::DivergenceAfter}, {"before", Track::DivergenceBefore}};
constexpr Curve phases[] = {{"total", Track::TotalMs},
                            {"projection", Track::ProjectionMs},
                            {"advection", Track::AdvectionMs},
                            {"forces", Track::ForcesMs}};

using Scale = Chart::Scale;
using When = Chart::When;

constexpr Chart of_one_lane[] = {
    {"Error", "", Scale::Logarithmic, When::Errors, error},
    {"Total smoke", "%", Scale::Percent, When::Always, total},
    {"Kinetic energy", "", Scale::Fitted, When::Solved, energy},
    {"Enstrophy", "", Scale::Fitted, When::Solved, enstrophy},
    {"Density", "", Scale::Density, When::Always, extrema},
    {"Limited nodes", "", Scale::Fitted, When::Limiters, limited},
    {"Max |∇·u|", "1/time", Scale::Logarithmic, When::Solved, divergence},
    {"Step time", "ms", Scale::Milliseconds, When::Always, phases},
};
constexpr Chart of_many_lanes[] = {
    {"Error", "", Scale::Logarithmic, When::Errors, error},
    {"Total smoke", "%", Scale::Percent, When::Always, total},
    {"Kinetic energy", "", Scale::Fitted, When::Solved, energy},
    {"Enstrophy", "", Scale::Fitted, When::Solved, enstrophy},
    {"Largest density", "", Scale::Density, When::Always, largest},
    {"Smallest density", "", Scale::Density, When::Always, smallest},
    {"Limited nodes of smoke", "", Scale::Fitted, When::Limiters, limited},
    {"Max |∇·u|", "1/time", Scale::Logarithmic, When::Solved, divergence},
    {"Step time", "ms", Scale::Milliseconds, When::Always, phases},
};

/// A line of a chart, of whichever lane.
struct Line {
    std::string label;
    int colour;  ///< place in the palette
    std::span<const float> x, y;
};

bool wanted(const Chart& chart, const SessionSnapshot& moment) {
    if (chart.when == When::Errors) return has_errors(moment);
    if (chart.when == When::Limiters)
        return std::any_of(moment.lanes.begin(), moment.lanes.end(),
                           [](const Snapshot& lane) { return lane.limits.has_value(); });
    if (chart.when == When::Solved) return std::any_of(moment.lanes.begin(), moment.lanes.end(), is_solved);
    return true;
}

std::vector<const Chart*> charts_for(const SessionSnapshot& moment) {
    const bool one = moment.lanes.size() == 1;
    std::vector<const Chart*> chosen;
    for (const Chart& chart : one ? std::span<const Chart>(of_one_lane) : of_many_lanes) {
        if (wanted(chart, moment)) chosen.push_back(&chart);
    }
    return chosen;
}

const Curve& chosen_curve(const Chart& chart, const MeasureView& view) {
    for (const Curve& curve : chart.curves) {
        if (curve.track == view.norm) return curve;
    }
    return chart.curves.front();
}

/// The chart's title; with several lanes it says which norm is shown.
std::string title_of(const Chart& chart, const SessionSnapshot& moment, const MeasureView& view) {
    const bool norm = chart.when == When::Errors && moment.lanes.size() > 1;
    return norm ? std::string(chart.title) + " " + chosen_curve(chart, view).label : chart.title;
}

std::vector<Line> lines_of(const Chart& chart, const History& history, const SessionSnapshot& moment,
                           const LaneNames& names, const MeasureView& view) {
    std::vector<Line> lines;
    if (moment.lanes.size() == 1) {
        const LaneHistory& lane = history.lane(moment.ids.front());
        for (const Curve& curve : chart.curves)
            lines.push_back({curve.label, static_cast<int>(lines.size()), lane.steps, lane.of(curve.track)});
        return lines;
    }
    const Track track = chosen_curve(chart, view).track;
    for (std::size_t k = 0; k < moment.lanes.size(); ++k) {
        const LaneHistory& lane = history.lane(moment.ids[k]);
        lines.push_back({names.name(k), static_cast<int>(k), lane.steps, lane.of(track)});
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
    if (chart.scale == Scale::Fitted || chart.scale == Scale::Logarithmic) return {};
    std::vector<float> known;
    for (const Line& line : lines) {
        std::copy_if(line.y.begin(), line.y.end(), std::back_inserter(known),
                     [](float y) { return std::isfinite(y); });
        if (chart.scale == Scale::Milliseconds && lines.size() == chart.curves.size()) break;  // the total
    }
    if (known.empty()) return {};
    if (chart.scale == Scale::Percent) return around(known, 99, 101);
    if (chart.scale == Scale::Density) return around(known, 0, 0.05);
    const auto high = known.begin() + static_cast<long>(0.98 * static_cast<double>(known.size()));
    std::nth_element(known.begin(), high, known.end());
    if (*high > 0) return Interval{0, 1.4 * static_cast<double>(*high)};
    return {};
}

std::optional<double> draw(PanelContext& context, const Chart& chart, float height) {
    const SessionSnapshot& moment = context.client.session();
    const std::vector<Line> lines = lines_of(chart, context.history, moment, context.names, context.measures);
    std::vector<Series> series;
    for (const Line& line : lines) {
        Series one{line.label, context.theme.lane(line.colour), line.y};
        one.x = line.x;
        series.push_back(one);
    }
    const std::string title = title_of(chart, moment, context.measures);
    Plot plot;
    plot.title = title;
    plot.unit = chart.unit;
    plot.legend = moment.lanes.size() == 1;
    plot.log_y = chart.scale == Scale::Logarithmic;
    plot.y_range = range_of(chart, lines);
    plot.marker = context.measures.marker;
    if (chart.when == When::Errors) plot.empty_text = "nothing to compare with so far";
    plot.size = {0, height};
    return draw_on_card(context, plot, series);
}

void norm_chips(PanelContext& context) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    row_label(context.theme, "Error norm");
    const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
    for (const Curve& curve : error) {
        if (&curve != error) ImGui::SameLine();
        if (chip(context.theme, curve.label, context.measures.norm == curve.track, width))
            context.measures.norm = curve.track;
        const std::string key = "norm=" + std::string(curve.label);
        context.log.control(key);
        context.tooltip.item(context.theme, key,
                             {"Error norm",
                              "Which error the lanes are compared by: L1 the mean, L2 the root of the mean "
                              "square, L∞ the largest.",
                              "", "thesis eq. 5.4, 5.6, 5.7", ""});
    }
}

void draw_frame_time(PanelContext& context, float height) {
    const FrameLog& frames = context.frames;
    char title[48];
    std::snprintf(title, sizeof title, "Frame time · %.0f fps", frames.frames_per_second());
    Plot plot;
    plot.title = title;
    plot.unit = "ms";
    plot.x_name = "frame";
    plot.x_first = static_cast<double>(frames.first());
    plot.y_range =
        Interval{0, std::max(25.0, 1.1 * static_cast<double>(*std::max_element(frames.intervals().begin(),
                                                                               frames.intervals().end())))};
    plot.size = {0, height};
    const auto& colours = context.theme.palette.series;
    const Series series[] = {{"frame", colours[0], frames.intervals()}, {"busy", colours[1], frames.work()}};
    draw_on_card(context, plot, series);
    context.log.control("plot=frame-time");
}

}  // namespace

bool is_solved(const Snapshot& lane) {
    return experiment(lane.scene.experiment).flow == nullptr;
}

bool has_errors(const SessionSnapshot& moment) {
    return moment.setup.reference != no_reference ||
           experiment(moment.setup.scene.experiment).exact != nullptr;
}

std::optional<double> draw_on_card(PanelContext& context, const Plot& plot, std::span<const Series> series) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high{low.x + ImGui::GetContentRegionAvail().x, low.y + plot.size.y};
    context.backgrounds.add(*ImGui::GetWindowDrawList(), low, high, context.theme.px(5),
                            context.theme.palette.card);
    Theme bare = context.theme;
    bare.palette.card = 0;
    return draw_plot(bare, plot, series);
}

void draw_plots_tab(PanelContext& context) {
    const Theme& theme = context.theme;
    const SessionSnapshot& moment = context.client.session();
    if (moment.lanes.size() > 1 && has_errors(moment)) norm_chips(context);
    const auto charts = charts_for(moment);
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float room = ImGui::GetContentRegionAvail().y / static_cast<float>(charts.size() + 1) - gap;
    const float height = std::floor(std::clamp(room, theme.px(118), theme.px(320)));
    std::optional<double> hovered;
    for (const Chart* chart : charts) {
        const auto x = draw(context, *chart, height);
        context.log.control("plot=" + std::string(chart->title));
        if (x) hovered = x;
    }
    if (!context.frames.intervals().empty()) draw_frame_time(context, height);
    context.measures.marker = hovered;
}

std::vector<SheetPlot> plots_of(const History& history, const SessionSnapshot& moment,
                                const MeasureView& view) {
    LaneNames names;
    names.update(moment.setup);
    std::vector<SheetPlot> plots;
    for (const Chart* chart : charts_for(moment)) {
        if (chart->scale == Scale::Milliseconds) continue;
        SheetPlot plot;
        plot.title = title_of(*chart, moment, view);
        plot.unit = chart->unit;
        plot.log_y = chart->scale == Scale::Logarithmic;
        for (const Line& line : lines_of(*chart, history, moment, names, view)) {
            const auto until =
                std::upper_bound(line.x.begin(), line.x.end(), static_cast<float>(moment.step));
            const auto count = until - line.x.begin();
            plot.curves.push_back(
                {line.label, line.colour, {line.x.begin(), until}, {line.y.begin(), line.y.begin() + count}});
        }
        plots.push_back(std::move(plot));
    }
    return plots;
}

}  // namespace whorl::app
