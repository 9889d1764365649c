#include "app/panels/curve_view.h"

#include <algorithm>
#include <array>
#include <limits>

#include "app/plot/plot.h"

namespace whorl::app {
namespace {

/// A row of samples at their places.
struct Curve {
    std::vector<float> x, y;
};

Curve curve_of(const Field& field, const Grid& grid) {
    Curve curve;
    for (int i = 0; i < field.width(); ++i) {
        curve.x.push_back(static_cast<float>((i + 0.5) * grid.h));
        curve.y.push_back(static_cast<float>(field(i, 0)));
    }
    return curve;
}

Series series_of(const Curve& curve, std::string_view label, ImU32 colour, bool dots) {
    return {label, colour, curve.y, dots, curve.x};
}

/// One scale for all times, so that a bump that sinks is seen to sink; it makes way for what overshoots.
Interval steady_scale(std::span<const Curve> curves, double most) {
    float least = 0;
    for (const Curve& curve : curves) {
        for (const float value : curve.y) least = std::min(least, value);
    }
    return {std::min(-0.05, 1.05 * static_cast<double>(least)), std::max(1.05, 1.02 * most)};
}

/// The lane whose curve is nearest; the selected one where others are as near.
/// @param lanes  of the curves
/// @param away   how far the curves are, pixels; of these and of others behind them
std::size_t nearest(std::span<const std::size_t> lanes, std::span<const float> away, std::size_t selected) {
    constexpr float same = 1;  // pixel
    std::size_t best = selected;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        if (lanes[k] == selected) least = away[k] - same;
    }
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        if (away[k] >= least) continue;
        least = away[k];
        best = lanes[k];
    }
    return best;
}

}  // namespace

void CurveView::draw(ImVec2 size) {
    const Theme& theme = ui_.theme;
    const Snapshot& selected = run_.snapshot();
    const View& view = fields_.view();
    const bool several = run_.names().size() > 1;
    const bool compares = selected.has_exact && &view == views().front() && !fields_.difference();

    std::array<Curve, Setup::max_lanes> curves;
    Curve exact;
    std::vector<Series> series;
    std::vector<std::size_t> lanes;  // of the series
    for (std::size_t k = 0; k < run_.names().size(); ++k) {
        if (fields_.of(k) == nullptr) continue;
        curves[k] = curve_of(*fields_.of(k), run_.session().lanes[k].grid());
        const std::string_view alone = compares ? "numerical" : view.label;
        series.push_back(series_of(curves[k], several ? run_.names().name(k) : alone,
                                   theme.lane(static_cast<int>(k)), !several));
        lanes.push_back(k);
    }
    if (compares) {
        exact = curve_of(selected.exact, selected.grid());
        const ImU32 colour = several ? theme.palette.text : theme.palette.series[1];
        series.push_back(series_of(exact, "exact", colour, false));
    }
    Plot plot;
    const std::string difference =
        fields_.difference() ? shown_quantity(fields_, run_.names()) : std::string();
    plot.title = difference.empty() ? selected.scene.title : difference;
    plot.x_name = "x";
    plot.x_first = 0.5 * selected.grid().h;
    plot.x_stride = selected.grid().h;
    const Range ends = view_.range.ends();
    if (view_.range.held()) {
        plot.y_range = Interval{static_cast<double>(ends.lo), static_cast<double>(ends.hi)};
    } else if (compares) {
        plot.y_range = steady_scale(curves, static_cast<double>(ends.hi));
    }
    plot.size = size;
    const std::vector<PlotMark> marks = layers_.marks();
    plot.marks = marks;
    std::vector<float> away;
    const std::optional<double> x = draw_plot(theme, plot, series, &away);
    if (x) layers_.hover_curves(*x, nearest(lanes, away, run_.selected()));
}

}  // namespace whorl::app
