#include "app/panels/curve_view.h"

#include "app/plot/plot.h"

namespace whorl::app {
namespace {

std::vector<float> row_of(const Field& field) {
    std::vector<float> values;
    for (int i = 0; i < field.width(); ++i) values.push_back(static_cast<float>(field(i, 0)));
    return values;
}

}  // namespace

void draw_curve_view(PanelContext& context, ImVec2 size) {
    const Snapshot& s = context.snapshot();
    const auto& colours = context.theme.palette.series;
    const View& view = *context.view.shown;
    const std::vector<float> shown = row_of(*context.field);
    const bool compares = s.has_exact && &view == &views().front();
    const std::vector<float> exact = compares ? row_of(s.exact) : std::vector<float>();

    std::vector<Series> series;
    series.push_back({compares ? "numerical" : view.label, colours[0], shown, true});
    if (compares) series.push_back({"exact", colours[1], exact});
    Plot plot;
    plot.title = s.scene.title;
    plot.x_name = "x";
    plot.x_first = 0.5 * s.grid.h;
    plot.x_stride = s.grid.h;
    const Range ends = context.view.range.ends();
    if (context.view.range.held()) {
        plot.y_range = Interval{static_cast<double>(ends.lo), static_cast<double>(ends.hi)};
    } else if (compares) {
        // One scale for all times, so that a bump that sinks is seen to sink.
        const auto most = static_cast<double>(std::max(1.05f, 1.02f * ends.hi));
        plot.y_range = Interval{-0.05, most};
    }
    plot.size = size;
    draw_plot(context.theme, plot, series);
}

}  // namespace whorl::app
