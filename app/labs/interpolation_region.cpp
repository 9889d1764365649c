#include "app/labs/interpolation_region.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/labs/canvas.h"
#include "app/labs/lab_widgets.h"
#include "app/labs/monotone_region.h"

namespace whorl::app {
namespace {

/// The region of Figure 3.6 with its two subsets.
void draw_region(const Theme& theme, const Canvas& canvas) {
    std::vector<ImVec2> outline{canvas.pixel(0, 0)};
    constexpr int parts = 64;
    for (int k = 0; k <= parts; ++k) {
        const glm::dvec2 at = region_boundary(k / static_cast<double>(parts));
        outline.push_back(canvas.pixel(at.x, at.y));
    }
    ImDrawList& list = canvas.begin();
    list.AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()),
                             faded(theme.palette.series[1], 0.16f));
    list.AddPolyline(outline.data(), static_cast<int>(outline.size()), theme.palette.series[1],
                     ImDrawFlags_Closed, theme.px(1));
    canvas.end();
    std::vector<ImVec2> circle;
    for (int k = 0; k <= parts; ++k) {
        const double angle = 0.5 * std::numbers::pi * k / parts;
        circle.push_back(canvas.pixel(3 * std::cos(angle), 3 * std::sin(angle)));
    }
    canvas.dashes(circle, theme.palette.series[0]);
    const ImVec2 square[] = {canvas.pixel(3, 0), canvas.pixel(3, 3), canvas.pixel(0, 3)};
    canvas.dashes(square, theme.palette.text_dim);
}

/// The intervals of α and β.
struct SlopeAxes {
    Interval x{-0.6, 4.6}, y{-0.6, 4.6};
};

/// As far as the points lie, up to a limit at which those beyond it stay.
SlopeAxes axes_of(const InterpolationState& lab, const IntervalReports& reports) {
    constexpr double furthest = 9;
    SlopeAxes axes;
    const auto reach = [&](Interval& axis, double value) {
        axis.lo = std::min(axis.lo, std::max(value, -furthest) - 0.6);
        axis.hi = std::max(axis.hi, std::min(value, furthest) + 0.6);
    };
    for (std::size_t k = 0; k < reports.size(); ++k) {
        if (!lab.shown[k] || reports[k].flat) continue;
        reach(axes.x, reports[k].alpha);
        reach(axes.y, reports[k].beta);
    }
    return axes;
}

std::string describe(const IntervalReport& report) {
    return "α = " + signed_number(report.alpha) + ", β = " + signed_number(report.beta) +
           (is_monotone(report.alpha, report.beta) ? ": in the monotone region."
                                                   : ": outside the monotone region.");
}

}  // namespace

std::string signed_number(double value) {
    char line[32];
    std::snprintf(line, sizeof line, "%.2f", std::round(100 * value) / 100 + 0.0);  // + 0.0: no "-0.00"
    return line[0] == '-' ? "−" + std::string(line + 1) : line;
}

void draw_region_plot(Ui& ui, const InterpolationState& lab, const IntervalReports& reports, float height) {
    const Theme& theme = ui.theme;
    Plot plot;
    plot.title = "Slopes over the secant: α to the right, β upwards";
    plot.x_name = "α";
    plot.size = {0, height};
    const auto [x, y] = axes_of(lab, reports);
    const LegendEntry legend[] = {{"monotone", theme.palette.series[1], true},
                                  {"circle, radius 3", theme.palette.series[0]},
                                  {"square, side 3", theme.palette.text_dim}};
    const Canvas canvas(theme, plot, legend, x, y, Canvas::Units::Equal);
    ui.log.control("interpolation-region");
    if (!canvas) return;
    draw_region(theme, canvas);
    std::optional<std::size_t> under;
    for (const std::size_t k : drawing_order(lab)) {
        if (reports[k].flat) continue;
        const Frame& f = canvas.frame();
        const double alpha = std::clamp(reports[k].alpha, f.x.lo, f.x.hi);
        const double beta = std::clamp(reports[k].beta, f.y.lo, f.y.hi);
        const bool beyond = alpha != reports[k].alpha || beta != reports[k].beta;
        const ImU32 colour = interpolation_colour(theme, k);
        const float radius = theme.px(lab.pointed == k ? 6.5f : 4.5f);
        if (beyond) {
            canvas.ring(alpha, beta, radius, colour);
        } else {
            canvas.dot(alpha, beta, radius, colour);
        }
        const ImVec2 at = canvas.pixel(alpha, beta);
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        if (canvas.hovered() && std::hypot(at.x - mouse.x, at.y - mouse.y) <= theme.px(7)) under = k;
    }
    const std::string title =
        under ? std::string(Id<Interpolation>::at(*under).info().label) : "Monotonicity region";
    const std::string what =
        under ? describe(reports[*under])
              : "A cubic is monotone between its ends where its slopes, over the secant's, lie in "
                "the blue region.";
    ui.tooltip.item(theme, "interpolation-region" + title,
                    {title, what, "", "Fritsch and Carlson 1980; thesis eq. 3.16–3.20, fig. 3.6", ""});
}

}  // namespace whorl::app
