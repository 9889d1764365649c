#include "app/panels/curve_view.h"

#include <array>

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

/// Whether a lane's curve is drawn.
bool drawn(const PanelContext& context, std::size_t lane) {
    if (context.fields.of(lane) == nullptr) return false;
    if (context.view.compare != Compare::One) return true;
    return lane == (context.view.peek ? context.remote.other() : context.remote.selected());
}

}  // namespace

void draw_curve_view(PanelContext& context, ImVec2 size) {
    const Theme& theme = context.theme;
    const Snapshot& selected = context.snapshot();
    const View& view = context.fields.view();
    const bool several = context.names.size() > 1;
    const bool compares = selected.has_exact && &view == &views().front() && !context.fields.difference();

    std::array<Curve, Setup::max_lanes> curves;
    Curve exact;
    std::vector<Series> series;
    for (std::size_t k = 0; k < context.names.size(); ++k) {
        if (!drawn(context, k)) continue;
        curves[k] = curve_of(*context.fields.of(k), context.remote.session().lanes[k].grid);
        const std::string_view alone = compares ? "numerical" : view.label;
        series.push_back(series_of(curves[k], several ? context.names.name(k) : alone,
                                   theme.lane(static_cast<int>(k)), !several));
    }
    if (compares) {
        exact = curve_of(selected.exact, selected.grid);
        const ImU32 colour = several ? theme.palette.text : theme.palette.series[1];
        series.push_back(series_of(exact, "exact", colour, false));
    }
    Plot plot;
    plot.title = selected.scene.title;
    plot.x_name = "x";
    plot.x_first = 0.5 * selected.grid.h;
    plot.x_stride = selected.grid.h;
    const Range ends = context.view.range.ends();
    if (context.view.range.held()) {
        plot.y_range = Interval{static_cast<double>(ends.lo), static_cast<double>(ends.hi)};
    } else if (compares) {
        // One scale for all times, so that a bump that sinks is seen to sink.
        const auto most = static_cast<double>(std::max(1.05f, 1.02f * ends.hi));
        plot.y_range = Interval{-0.05, most};
    }
    plot.size = size;
    draw_plot(theme, plot, series);
}

}  // namespace whorl::app
