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
    const Quantity& quantity = *context.view.quantity;
    Field scratch;
    const std::vector<float> shown = row_of(quantity.field(s, scratch));
    const bool compares = s.has_exact && quantity.key == "density";
    const std::vector<float> exact = compares ? row_of(s.exact) : std::vector<float>();

    std::vector<Series> series;
    series.push_back({compares ? "numerical" : quantity.label, colours[0], shown, true});
    if (compares) series.push_back({"exact", colours[1], exact});
    Plot plot;
    plot.title = s.scene.title;
    plot.x_name = "x";
    plot.x_first = 0.5 * s.grid.h;
    plot.x_stride = s.grid.h;
    const ColourRange& range = context.view.range;
    if (range.held()) {
        plot.y_range = Interval{static_cast<double>(range.lo()), static_cast<double>(range.hi())};
    } else if (compares) {
        // One scale for all times, so that a bump that sinks is seen to sink.
        const auto most = static_cast<double>(std::max(1.05f, 1.02f * range.hi()));
        plot.y_range = Interval{-0.05, most};
    }
    plot.size = size;
    draw_plot(context.theme, plot, series);
}

}  // namespace whorl::app
