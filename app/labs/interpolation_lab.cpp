#include "app/labs/interpolation_lab.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/labs/canvas.h"
#include "app/labs/data_sets.h"
#include "app/labs/field_sampling.h"
#include "app/labs/interval_report.h"
#include "app/labs/lab_widgets.h"
#include "app/labs/monotone_region.h"
#include "app/render/text.h"
#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

constexpr int per_interval = 48;

std::size_t schemes_count() {
    return Interpolation::list().all().size();
}

struct Curves {
    std::vector<float> x;
    std::vector<std::vector<float>> y;  ///< by interpolation
};

/// Every interpolation of a row between two of its points.
Curves curves_of(const Field& row, bool clamped, int first, int last) {
    Curves curves;
    std::vector<glm::dvec2> places;
    for (int m = first * per_interval; m <= last * per_interval; ++m) {
        const double x = m / static_cast<double>(per_interval);
        places.emplace_back(m < last * per_interval ? x : from_the_left(x), 0);
        curves.x.push_back(static_cast<float>(x));
    }
    for (std::size_t k = 0; k < schemes_count(); ++k) {
        SchemeSet schemes;
        schemes.interpolation = Id<Interpolation>::at(k);
        schemes.clamped = clamped;
        curves.y.emplace_back(places.size());
        sample_field(row, schemes, false, places, curves.y[k]);
    }
    return curves;
}

void choose(InterpolationLab& lab, std::size_t data_set) {
    const DataSet& chosen = data_sets()[data_set];
    lab.data_set = data_set;
    lab.values.assign(chosen.values.begin(), chosen.values.end());
    lab.interval = chosen.interval;
    lab.dragged.reset();
}

void controls(PanelContext& context, InterpolationLab& lab) {
    const auto count = static_cast<int>(data_sets().size());
    const float width = chip_width(count + 1);
    for (std::size_t k = 0; k < data_sets().size(); ++k) {
        const DataSet& set = data_sets()[k];
        const bool as_it_was = lab.data_set == k && std::equal(set.values.begin(), set.values.end(),
                                                               lab.values.begin(), lab.values.end());
        if (lab_chip(context, "interpolation-data=" + std::string(set.key),
                     {set.label, set.help, "", set.source, ""}, as_it_was, width, k == 0))
            choose(lab, k);
    }
    ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x);
    if (check("Clamped", lab.clamped)) lab.clamped = !lab.clamped;
    context.log.control("interpolation-clamped");
    context.tooltip.item(context.theme, "interpolation-clamped",
                         {"Clamped", "Cuts what an interpolation gives to the interval's two points.", "",
                          "thesis eq. 3.8", ""});
}

/// The curves from back to front: the one that is pointed at lies over the others.
std::vector<std::size_t> drawing_order(const InterpolationLab& lab) {
    std::vector<std::size_t> order;
    for (std::size_t k = schemes_count(); k-- > 0;) {
        if (lab.shown[k] && lab.pointed != k) order.push_back(k);
    }
    if (lab.pointed && lab.shown[*lab.pointed]) order.push_back(*lab.pointed);
    return order;
}

/// Curves that lie on each other take turns, so that each of them is seen: as dashes in their colours.
void draw_curves(const Theme& theme, const InterpolationLab& lab, const Canvas& canvas,
                 const Curves& curves) {
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

void draw_points(const Theme& theme, const InterpolationLab& lab, const Canvas& canvas) {
    for (std::size_t k = 0; k < lab.values.size(); ++k) {
        canvas.dot(static_cast<double>(k), static_cast<double>(lab.values[k]),
                   theme.px(lab.dragged == k ? 5.0f : 4.0f), theme.palette.text);
    }
}

/// The point that the pointer is on, if any.
std::optional<std::size_t> point_under(const Theme& theme, const InterpolationLab& lab,
                                       const Canvas& canvas) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (std::size_t k = 0; k < lab.values.size(); ++k) {
        const ImVec2 at = canvas.pixel(static_cast<double>(k), static_cast<double>(lab.values[k]));
        if (std::hypot(at.x - mouse.x, at.y - mouse.y) <= theme.px(9)) return k;
    }
    return std::nullopt;
}

/// A press on a point takes it, beside one it chooses the interval; a point that is held follows.
void act(const Theme& theme, InterpolationLab& lab, const Canvas& canvas) {
    if (canvas.pressed() && canvas.hovered()) {
        lab.dragged = point_under(theme, lab, canvas);
        if (!lab.dragged)
            lab.interval = std::clamp(static_cast<int>(std::floor(canvas.pointer_x())), 0,
                                      static_cast<int>(lab.values.size()) - 2);
    }
    if (!canvas.held()) lab.dragged.reset();
    if (lab.dragged) {
        const Interval& y = canvas.frame().y;
        lab.values[*lab.dragged] = static_cast<float>(std::clamp(canvas.pointer_y(), y.lo, y.hi));
    }
}

Extent extent_of(const InterpolationLab& lab, const Curves& curves) {
    Extent extent;
    for (std::size_t k = 0; k < schemes_count(); ++k) {
        if (lab.shown[k]) extent.add(curves.y[k]);
    }
    return extent;
}

void main_plot(PanelContext& context, InterpolationLab& lab, const Curves& curves, float height) {
    const Theme& theme = context.theme;
    Plot plot;
    plot.title = "Data and what lies between";
    plot.x_name = "x";
    plot.size = {0, height};
    if (!lab.dragged) {
        Extent extent = extent_of(lab, curves);
        extent.add(lab.values);
        lab.y = extent.fitted();
    }
    const double last = static_cast<double>(lab.values.size()) - 1;
    const Canvas canvas(theme, plot, {}, {-0.2, last + 0.2}, lab.y);
    context.log.control("interpolation-plot");
    if (!canvas) return;
    const bool on_point = canvas.hovered() && point_under(theme, lab, canvas);
    if (!on_point)
        context.tooltip.item(
            theme, "interpolation-plot",
            {"Data points", "Drag a point up or down. Click between two to choose their interval.", "",
             "thesis fig. 3.5", ""});
    if (on_point || lab.dragged) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    act(theme, lab, canvas);
    canvas.band(lab.interval, lab.interval + 1, faded(theme.palette.text, 0.07f));
    draw_curves(theme, lab, canvas, curves);
    draw_points(theme, lab, canvas);
    for (std::size_t k = 0; k < lab.values.size(); ++k) {
        const ImVec2 at = canvas.pixel(static_cast<double>(k), static_cast<double>(lab.values[k]));
        const float half = theme.px(9);
        context.log.rect("interpolation-point=" + std::to_string(k), at.x - half, at.y - half, 2 * half,
                         2 * half);
    }
}

/// The chosen interval alone, as the figure's inset: its extrema are seen where they are slight.
void inset(PanelContext& context, const InterpolationLab& lab, const Field& row, float height) {
    const Theme& theme = context.theme;
    const std::string title =
        "Between " + std::to_string(lab.interval) + " and " + std::to_string(lab.interval + 1);
    Plot plot;
    plot.title = title;
    plot.x_name = "x";
    plot.size = {0, height};
    const Curves curves = curves_of(row, lab.clamped, lab.interval, lab.interval + 1);
    const std::array ends{lab.values[static_cast<std::size_t>(lab.interval)],
                          lab.values[static_cast<std::size_t>(lab.interval) + 1]};
    Extent extent = extent_of(lab, curves);
    extent.add(ends);
    const Canvas canvas(theme, plot, {}, {lab.interval - 0.02, lab.interval + 1.02}, extent.tight());
    context.log.control("interpolation-inset");
    if (!canvas) return;
    context.tooltip.item(theme, "interpolation-inset",
                         {"The chosen interval",
                          "The figure's inset. Between the two lines a curve is in the "
                          "range of the interval's points.",
                          "", "thesis fig. 3.5", ""});
    for (const float end : ends) {
        const ImVec2 at = canvas.pixel(0, static_cast<double>(end));
        canvas.begin().AddLine({canvas.frame().low.x, sharp(at.y)}, {canvas.frame().high.x, sharp(at.y)},
                               theme.palette.hairline, theme.thin());
        canvas.end();
    }
    draw_curves(theme, lab, canvas, curves);
    draw_points(theme, lab, canvas);
}

using Reports = std::vector<IntervalReport>;  // by interpolation

std::string signed_number(double value) {
    char line[32];
    std::snprintf(line, sizeof line, "%.2f", std::round(100 * value) / 100 + 0.0);  // + 0.0: no "-0.00"
    return line[0] == '-' ? "−" + std::string(line + 1) : line;
}

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

/// α and β of every curve in the region that keeps a cubic monotone.
void region_plot(PanelContext& context, const InterpolationLab& lab, const Reports& reports, float height) {
    const Theme& theme = context.theme;
    Plot plot;
    plot.title = "Slopes over the secant: α to the right, β upwards";
    plot.x_name = "α";
    plot.size = {0, height};
    // As far as the points lie, up to a limit at which those beyond it stay.
    constexpr double furthest = 9;
    Interval x{-0.6, 4.6}, y{-0.6, 4.6};
    for (std::size_t k = 0; k < schemes_count(); ++k) {
        if (!lab.shown[k] || reports[k].flat) continue;
        const auto reach = [&](Interval& axis, double value) {
            axis.lo = std::min(axis.lo, std::max(value, -furthest) - 0.6);
            axis.hi = std::max(axis.hi, std::min(value, furthest) + 0.6);
        };
        reach(x, reports[k].alpha);
        reach(y, reports[k].beta);
    }
    const LegendEntry legend[] = {{"monotone", theme.palette.series[1], true},
                                  {"circle, radius 3", theme.palette.series[0]},
                                  {"square, side 3", theme.palette.text_dim}};
    const Canvas canvas(theme, plot, legend, x, y, Canvas::Units::Equal);
    context.log.control("interpolation-region");
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
    std::string what =
        "A cubic is monotone between its ends where its slopes, over the secant's, lie in the blue region.";
    std::string title = "Monotonicity region";
    if (under) {
        title = Id<Interpolation>::at(*under).info().label;
        what = "α = " + signed_number(reports[*under].alpha) +
               ", β = " + signed_number(reports[*under].beta) +
               (is_monotone(reports[*under].alpha, reports[*under].beta) ? ": in the monotone region."
                                                                         : ": outside the monotone region.");
    }
    context.tooltip.item(theme, "interpolation-region" + title,
                         {title, what, "", "Fritsch and Carlson 1980; thesis eq. 3.16–3.20, fig. 3.6", ""});
}

/// The columns of the table, pixels from its left edge.
struct TableColumns {
    float name, alpha, beta, verdict, end;
    TableColumns(const Theme& theme, float width)
        : name(theme.px(20)),
          alpha(width - theme.px(196)),
          beta(width - theme.px(148)),
          verdict(width - theme.px(100)),
          end(width) {}
};

void table_head(const Theme& theme, const TableColumns& columns) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto put = [&](float x, const char* line) {
        add_text(list, *theme.small, {at.x + x, at.y}, theme.palette.text_dim, line);
    };
    put(columns.name, "Interpolation");
    put(columns.alpha, "α");
    put(columns.beta, "β");
    put(columns.verdict, "in the interval");
    ImGui::Dummy({columns.end, theme.small->FontSize + theme.px(2)});
}

void table_row(PanelContext& context, InterpolationLab& lab, std::size_t k, const IntervalReport& report,
               const TableColumns& columns) {
    const Theme& theme = context.theme;
    const SchemeInfo& info = Id<Interpolation>::at(k).info();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = theme.body->FontSize + theme.px(6);
    const std::string key = "interpolation-scheme=" + std::string(info.key);
    if (ImGui::InvisibleButton(key.c_str(), {columns.end, height})) lab.shown[k] = !lab.shown[k];
    context.log.control(key);
    const bool hovered = ImGui::IsItemHovered();
    context.tooltip.item(theme, key,
                         {info.label, info.help, "Click to show it or leave it out", info.source, ""});
    if (hovered) lab.pointed = k;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered)
        list.AddRectFilled(at, {at.x + columns.end, at.y + height}, theme.palette.frame, theme.px(3));
    const float middle = std::floor(at.y + 0.5f * height);
    swatch(theme, {at.x + theme.px(9), middle}, interpolation_colour(theme, k), lab.shown[k]);
    const float strength = lab.shown[k] ? 1.0f : 0.5f;
    const float text_y = middle - 0.5f * theme.body->FontSize;
    const float small_y = middle - 0.5f * theme.small->FontSize;
    const ImU32 plain = faded(theme.palette.text, strength);
    const ImU32 dim = faded(theme.palette.text_dim, strength);
    add_text(list, *theme.body, {at.x + columns.name, text_y}, plain,
             fitted(*theme.body, info.label, columns.alpha - columns.name - theme.px(6)));
    const auto number = [&](float x, double value) {
        add_text(list, *theme.mono, {at.x + x, middle - 0.5f * theme.mono->FontSize}, plain,
                 report.flat ? "–" : signed_number(value));
    };
    number(columns.alpha, report.alpha);
    number(columns.beta, report.beta);
    const ImU32 tone = report.leaves_range() ? faded(theme.palette.accent, strength)
                       : report.turned > 0   ? plain
                                             : dim;
    add_text(list, *theme.small, {at.x + columns.verdict, small_y}, tone,
             fitted(*theme.small, report.verdict(), columns.end - columns.verdict));
}

/// The legend, which toggles the curves, and the numbers of each in the chosen interval.
void table(PanelContext& context, InterpolationLab& lab, const Reports& reports) {
    const TableColumns columns(context.theme, ImGui::GetContentRegionAvail().x);
    table_head(context.theme, columns);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    lab.pointed.reset();
    for (std::size_t k = 0; k < schemes_count(); ++k) table_row(context, lab, k, reports[k], columns);
    ImGui::PopStyleVar();
}

float table_height(const Theme& theme) {
    return theme.small->FontSize + theme.px(12) +
           static_cast<float>(schemes_count()) * (theme.body->FontSize + theme.px(6));
}

}  // namespace

void draw_interpolation_lab(PanelContext& context) {
    InterpolationLab& lab = context.view.labs.interpolation;
    const Theme& theme = context.theme;
    if (lab.values.empty()) choose(lab, 0);
    controls(context, lab);
    const Field row = row_of(lab.values);
    Reports reports;
    for (std::size_t k = 0; k < schemes_count(); ++k)
        reports.push_back(report_on(row, Id<Interpolation>::at(k), lab.clamped, lab.interval));

    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float right = std::clamp(0.4f * room.x, theme.px(330), theme.px(440));
    const float height = std::max(room.y, table_height(theme) + theme.px(150));
    ImGui::BeginChild("curves", {room.x - right - gap, height}, false, ImGuiWindowFlags_NoScrollbar);
    const float upper = std::floor(0.56f * (height - gap));
    main_plot(context, lab, curves_of(row, lab.clamped, 0, row.width() - 1), upper);
    inset(context, lab, row, height - gap - upper);
    ImGui::EndChild();
    ImGui::SameLine(0, gap);
    ImGui::BeginChild("numbers", {0, height}, false, ImGuiWindowFlags_NoScrollbar);
    region_plot(context, lab, reports, height - table_height(theme) - gap);
    table(context, lab, reports);
    ImGui::EndChild();
}

}  // namespace whorl::app
