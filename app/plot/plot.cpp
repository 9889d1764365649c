// See plot.h.
#include "app/plot/plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/plot/axes.h"
#include "app/plot/card.h"

namespace whorl::app {
namespace {

void draw_curve(ImDrawList& list, const Theme& theme, const Frame& frame, const Abscissa& abscissa,
                const std::vector<CurvePoint>& curve, ImU32 colour, bool dots, std::vector<ImVec2>& points) {
    const float thickness = curve_thickness(theme);
    const auto flush = [&] {
        // Where a curve turns within a pixel, a polyline gets too thin to see: fill such columns.
        for (std::size_t k = 1; k < points.size(); ++k) {
            const ImVec2 a = points[k - 1];
            const ImVec2 b = points[k];
            if (b.x - a.x > 1.5f || std::abs(b.y - a.y) < 2.0f * thickness) continue;
            const float left = std::round(0.5f * (a.x + b.x - thickness));
            list.AddRectFilled({left, std::min(a.y, b.y)}, {left + thickness, std::max(a.y, b.y)}, colour);
        }
        if (points.size() == 1) list.AddCircleFilled(points.front(), thickness, colour, 8);
        // Joints of a polyline thin out where it turns sharply, which shows where samples lie far apart.
        const bool sparse = points.size() > 1 && points.back().x - points.front().x >
                                                     4.0f * thickness * static_cast<float>(points.size());
        if (sparse) {
            for (std::size_t k = 1; k < points.size(); ++k) {
                list.AddLine(points[k - 1], points[k], colour, thickness);
            }
        } else if (points.size() > 1) {
            list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_None,
                             thickness);
        }
        for (std::size_t k = 0; dots && sparse && k < points.size(); ++k) {
            list.AddCircleFilled(points[k], theme.px(2.5f), colour, 10);
        }
        points.clear();
    };
    points.clear();
    for (const CurvePoint& point : curve) {
        const float x = frame.to_x(abscissa.at(point.index));
        if (std::isnan(point.y) || !std::isfinite(x)) {
            flush();
        } else {
            points.emplace_back(x, frame.to_y(static_cast<double>(point.y)));
        }
    }
    flush();
}

/// The value of a curve at x, if it reaches there.
std::optional<double> value_at(const Plot& plot, const Series& series, double x) {
    const Abscissa abscissa(plot, series);
    if (!abscissa.spans(x)) return std::nullopt;
    return static_cast<double>(series.y[abscissa.nearest(x)]);
}

void draw_dots(ImDrawList& list, const Theme& theme, const Plot& plot, std::span<const Series> series,
               const Frame& frame, double x) {
    const std::optional<float> pixel = draw_hairline(list, theme, frame, x);
    if (!pixel) return;
    list.PushClipRect(frame.low, frame.high, true);
    for (const Series& one : series) {
        const float y = frame.to_y(value_at(plot, one, x).value_or(NAN));
        if (!std::isfinite(y)) continue;
        list.AddCircleFilled({*pixel, y}, theme.px(4.5f), theme.palette.card);
        list.AddCircleFilled({*pixel, y}, theme.px(3.0f), one.colour);
    }
    list.PopClipRect();
}

void draw_marks(ImDrawList& list, const Theme& theme, const Plot& plot, const Frame& frame) {
    for (const PlotMark& mark : plot.marks) {
        const ImVec2 middle{frame.to_x(mark.x), frame.to_y(mark.y)};
        if (!std::isfinite(middle.x) || !std::isfinite(middle.y)) continue;
        const float radius = theme.px(mark.radius);
        list.AddCircleFilled(middle, radius + theme.px(1.5f), theme.palette.card);
        if (mark.filled) {
            list.AddCircleFilled(middle, radius, mark.colour);
        } else {
            list.AddCircle(middle, radius, mark.colour, 0, theme.px(2));
        }
    }
}

/// How far from a pixel the pieces of a curve pass; a sample by itself is no piece.
float distance(ImVec2 from, const std::vector<CurvePoint>& curve, const Abscissa& abscissa,
               const Frame& frame) {
    float least = std::numeric_limits<float>::infinity();
    const auto at = [&](const CurvePoint& point) {
        return ImVec2(frame.to_x(abscissa.at(point.index)), frame.to_y(static_cast<double>(point.y)));
    };
    for (std::size_t k = 1; k < curve.size(); ++k) {
        const ImVec2 a = at(curve[k - 1]), b = at(curve[k]);
        const float x = b.x - a.x, y = b.y - a.y, length2 = x * x + y * y;
        const float along = length2 > 0 ? ((from.x - a.x) * x + (from.y - a.y) * y) / length2 : 0;
        const float t = std::clamp(along, 0.0f, 1.0f);
        const float d = std::hypot(a.x + t * x - from.x, a.y + t * y - from.y);
        if (d < least) least = d;  // not where a sample is missing
    }
    return least;
}

/// Draws a card.
/// @param away  as draw_plot's
/// @return x of the sample under the pointer, if any
std::optional<double> paint(ImDrawList& list, const Theme& theme, const Plot& plot,
                            std::span<const Series> series, const Card& card,
                            std::vector<float>* away = nullptr) {
    list.PushClipRect(card.low, card.high, true);
    std::vector<LegendEntry> legend;
    for (const Series& one : plot.legend ? series : std::span<const Series>()) {
        legend.push_back({one.label, one.colour});
    }
    const float top = draw_card(list, theme, plot, legend, card);

    std::vector<std::vector<CurvePoint>> curves(series.size());
    std::size_t drawn = 0;
    for (std::size_t k = 0; k < series.size(); ++k) {
        const std::size_t count = Abscissa(plot, series[k]).count();
        // As wide as the frame can get; the y labels take some of it. On a logarithmic axis samples do not
        // share out evenly: all stay.
        const int columns = static_cast<int>(plot.log_x ? std::max<std::size_t>(count, 1)
                                                        : static_cast<std::size_t>(card.high.x - card.low.x));
        decimate(series[k].y.first(count), columns, plot.log_y, curves[k]);
        for (const CurvePoint& point : curves[k]) drawn += std::isnan(point.y) ? 0u : 1u;
    }

    std::optional<double> under;
    if (const auto axes = lay_out_axes(theme, plot, card, top, fit_x(plot, series),
                                       plot.y_range.value_or(fit_y(curves, plot.log_y)))) {
        const Frame& frame = axes->frame;
        if (drawn > 0) {
            draw_axes(list, theme, plot, *axes, card);
        } else {
            draw_emptiness(list, theme, plot, frame, card);
        }
        // A curve's width may reach over the frame's edge by a pixel or two, so that extrema are not cut.
        const float reach = theme.px(3.0f);
        list.PushClipRect({frame.low.x - reach, frame.low.y - reach},
                          {frame.high.x + reach, frame.high.y + reach}, true);
        std::vector<ImVec2> points;
        for (std::size_t k = series.size(); k-- > 0;) {
            draw_curve(list, theme, frame, Abscissa(plot, series[k]), curves[k], series[k].colour,
                       series[k].dots, points);
        }
        draw_marks(list, theme, plot, frame);
        list.PopClipRect();
        const std::optional<double> pointed = hovered_x(card, frame);
        if (pointed && drawn > 0) under = nearest_sample(plot, series, *pointed);
        const std::optional<double> hairline = under ? under : plot.marker;
        if (under && away != nullptr) {
            away->clear();
            for (std::size_t k = 0; k < series.size(); ++k)
                away->push_back(
                    distance(ImGui::GetIO().MousePos, curves[k], Abscissa(plot, series[k]), frame));
        }
        if (hairline) draw_dots(list, theme, plot, series, frame, *hairline);
    }
    list.PopClipRect();
    return under;
}

/// The curves' values at x, from top to bottom as the curves are, those without one last.
std::vector<ValueRow> values_at(const Plot& plot, std::span<const Series> series, double x) {
    std::vector<ValueRow> rows;
    for (const Series& one : series) rows.push_back({one.label, one.colour, value_at(plot, one, x)});
    std::stable_sort(rows.begin(), rows.end(), [](const ValueRow& a, const ValueRow& b) {
        const auto rank = [](const ValueRow& row) {
            return row.value && !std::isnan(*row.value) ? *row.value : -INFINITY;
        };
        return rank(a) > rank(b);
    });
    return rows;
}

}  // namespace

std::optional<double> draw_plot(const Theme& theme, const Plot& plot, std::span<const Series> series,
                                std::vector<float>* away) {
    const Card card = place_card(plot);
    if (!card.visible) return std::nullopt;
    const std::optional<double> x = paint(*ImGui::GetWindowDrawList(), theme, plot, series, card, away);
    if (x) show_values(theme, plot, *x, values_at(plot, series, *x));
    return x;
}

void paint_plot(ImDrawList& list, const Theme& theme, const Plot& plot, std::span<const Series> series,
                ImVec2 corner) {
    paint(list, theme, plot, series,
          {.low = corner, .high = {corner.x + plot.size.x, corner.y + plot.size.y}});
}

}  // namespace whorl::app
