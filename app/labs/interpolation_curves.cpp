#include "app/labs/interpolation_curves.h"

#include <algorithm>
#include <cmath>

#include "app/labs/field_sampling.h"
#include "app/labs/lab_widgets.h"

namespace whorl::app {
namespace {

constexpr int per_interval = 48;

}  // namespace

InterpolationCurves curves_of(const Field& row, bool clamped, int first, int last) {
    InterpolationCurves curves;
    std::vector<glm::dvec2> places;
    for (int m = first * per_interval; m <= last * per_interval; ++m) {
        const double x = m / static_cast<double>(per_interval);
        places.emplace_back(m < last * per_interval ? x : from_the_left(x), 0);
        curves.x.push_back(static_cast<float>(x));
    }
    for (std::size_t k = 0; k < Interpolation::list().all().size(); ++k) {
        SchemeSet schemes;
        schemes.interpolation = Id<Interpolation>::at(k);
        schemes.clamped = clamped;
        curves.y.emplace_back(places.size());
        sample_field(row, schemes, Wraps{}, places, curves.y[k]);
    }
    return curves;
}

std::vector<std::size_t> drawing_order(const InterpolationState& lab) {
    std::vector<std::size_t> order;
    for (std::size_t k = lab.shown.size(); k-- > 0;) {
        if (lab.shown[k] && lab.pointed != k) order.push_back(k);
    }
    if (lab.pointed && lab.shown[*lab.pointed]) order.push_back(*lab.pointed);
    return order;
}

Extent extent_of(const InterpolationState& lab, const InterpolationCurves& curves) {
    Extent extent;
    for (std::size_t k = 0; k < lab.shown.size(); ++k) {
        if (lab.shown[k]) extent.add(curves.y[k]);
    }
    return extent;
}

void draw_curves(const Theme& theme, const InterpolationState& lab, const Canvas& canvas,
                 const InterpolationCurves& curves) {
    constexpr float same = 0.25f;  // pixels
    const float turn = theme.px(9);
    const std::size_t segments = curves.x.size() - 1;
    std::vector<bool> drawn(segments);
    const std::vector<std::size_t> order = drawing_order(lab);
    const auto height = [&](std::size_t k, std::size_t m) {
        return canvas.pixel(0, static_cast<double>(curves.y[k][m])).y;
    };
    const auto one = [&](std::size_t a, std::size_t b, std::size_t m) {
        return std::abs(height(a, m) - height(b, m)) < same &&
               std::abs(height(a, m + 1) - height(b, m + 1)) < same;
    };
    for (const std::size_t k : order) {
        for (std::size_t m = 0; m < segments; ++m) {
            std::size_t place = 0, together = 0;
            for (const std::size_t other : order) {
                if (other != k && (lab.pointed == k || !one(k, other, m))) continue;
                if (other == k) place = together;
                ++together;
            }
            const float at = canvas.pixel(static_cast<double>(curves.x[m]), 0).x - canvas.frame().low.x;
            drawn[m] = static_cast<std::size_t>(std::max(at, 0.0f) / turn) % together == place;
        }
        const float thickness = lab.pointed == k ? 2 * curve_thickness(theme) : curve_thickness(theme);
        for (std::size_t from = 0, to = 0; from < segments; from = to) {
            to = from + 1;
            if (!drawn[from]) continue;
            while (to < segments && drawn[to]) ++to;
            canvas.curve(std::span(curves.x).subspan(from, to - from + 1),
                         std::span(curves.y[k]).subspan(from, to - from + 1), interpolation_colour(theme, k),
                         thickness);
        }
    }
}

void draw_points(const Theme& theme, const InterpolationState& lab, const Canvas& canvas) {
    for (std::size_t k = 0; k < lab.values.size(); ++k) {
        canvas.dot(static_cast<double>(k), static_cast<double>(lab.values[k]),
                   theme.px(lab.dragged == k ? 5.0f : 4.0f), theme.palette.text);
    }
}

}  // namespace whorl::app
