// See stack_plot.h.
#include "app/plot/stack_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/plot/axes.h"
#include "app/plot/card.h"
#include "app/plot/stacking.h"
#include "app/render/theme.h"

namespace whorl::app {
namespace {

/// Areas let the grid through.
constexpr float area_alpha = 0.7f;

/// Calls `run(first, end)` for every longest run of columns without a gap.
template <class Run>
void for_each_run(const Stacked& stacked, Run&& run) {
    for (std::size_t k = 0; k < stacked.columns(); ++k) {
        if (stacked.gap(k)) continue;
        const std::size_t first = k;
        while (k < stacked.columns() && !stacked.gap(k)) ++k;
        run(first, k);
    }
}

/// One part, above 0 or below: the area between where it begins and where it ends, and a line along that.
void draw_area(ImDrawList& list, const Frame& frame, const Stacked& stacked, std::size_t part, bool above,
               ImU32 colour) {
    const ImU32 area = faded(colour, area_alpha);
    const auto quad = [&](float left, const Interval& from, float right, const Interval& to) {
        if (from.lo == from.hi && to.lo == to.hi) return;
        list.AddQuadFilled({left, frame.to_y(from.lo)}, {right, frame.to_y(to.lo)},
                           {right, frame.to_y(to.hi)}, {left, frame.to_y(from.hi)}, area);
        list.AddLine({left, frame.to_y(from.hi)}, {right, frame.to_y(to.hi)}, colour);
    };
    for_each_run(stacked, [&](std::size_t first, std::size_t end) {
        Interval before = stacked.extent(first, part, above);
        float left = frame.to_x(stacked.x[first]);
        if (end - first == 1) quad(left - 1.0f, before, left + 1.0f, before);
        for (std::size_t k = first + 1; k < end; ++k) {
            const Interval now = stacked.extent(k, part, above);
            const float right = frame.to_x(stacked.x[k]);
            quad(left, before, right, now);
            before = now;
            left = right;
        }
    });
}

void draw_net(ImDrawList& list, const Theme& theme, const Frame& frame, const Stacked& stacked) {
    std::vector<ImVec2> points;
    for_each_run(stacked, [&](std::size_t first, std::size_t end) {
        points.clear();
        for (std::size_t k = first; k < end; ++k) {
            points.emplace_back(frame.to_x(stacked.x[k]), frame.to_y(static_cast<double>(stacked.net(k))));
        }
        // A rim keeps the line apart from the areas.
        for (const bool rim : {true, false}) {
            list.AddPolyline(points.data(), static_cast<int>(points.size()),
                             rim ? faded(theme.palette.background, 0.7f) : theme.palette.text,
                             ImDrawFlags_None, curve_thickness(theme) + (rim ? theme.px(2.0f) : 0.0f));
        }
    });
}

void draw_areas(ImDrawList& list, const Theme& theme, const Frame& frame, const Stacked& stacked,
                std::span<const Series> parts) {
    // Softened edges of neighbouring pieces would show as seams.
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (const bool above : {true, false}) {
            draw_area(list, frame, stacked, part, above, parts[part].colour);
        }
    }
    list.Flags = flags;
    const float zero = sharp(frame.to_y(0.0));
    list.AddLine({frame.low.x, zero}, {frame.high.x, zero}, theme.palette.text_dim, theme.thin());
    draw_net(list, theme, frame, stacked);
}

/// The contributions at x as they are, and their sum.
std::vector<ValueRow> values_at(const Theme& theme, const Plot& plot, std::span<const Series> parts, double x,
                                std::string_view net) {
    std::vector<ValueRow> rows;
    double sum = 0.0;
    for (const Series& part : parts) {
        const auto value = static_cast<double>(part.y[Abscissa(plot, part).nearest(x)]);
        rows.push_back({part.label, part.colour, value});
        sum += value;
    }
    rows.push_back({net, theme.palette.text, sum});
    return rows;
}

}  // namespace

std::optional<double> draw_stack(const Theme& theme, const Plot& asked, std::span<const Series> parts,
                                 std::string_view net) {
    Plot plot = asked;
    plot.log_x = plot.log_y = false;
    const Card card = place_card(plot);
    if (!card.visible) return std::nullopt;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(card.low, card.high, true);
    std::vector<LegendEntry> legend;
    for (const Series& part : parts) legend.push_back({part.label, part.colour, true});
    if (!parts.empty()) legend.push_back({net, theme.palette.text});
    const float top = draw_card(list, theme, plot, legend, card);

    const Stacked stacked = stack(plot, parts, static_cast<int>(card.high.x - card.low.x));
    bool empty = true;
    for (std::size_t k = 0; k < stacked.columns(); ++k) empty = empty && stacked.gap(k);
    std::optional<double> under;
    if (const auto axes = lay_out_axes(theme, plot, card, top, fit_x(plot, parts),
                                       plot.y_range.value_or(fit_stack(stacked)))) {
        const Frame& frame = axes->frame;
        if (empty) {
            draw_emptiness(list, theme, plot, frame, card);
        } else {
            draw_axes(list, theme, plot, *axes, card);
            list.PushClipRect(frame.low, frame.high, true);
            draw_areas(list, theme, frame, stacked, parts);
            list.PopClipRect();
            if (const auto pointed = hovered_x(card, frame)) under = nearest_sample(plot, parts, *pointed);
        }
        const std::optional<double> hairline = under ? under : plot.marker;
        if (hairline) draw_hairline(list, theme, frame, *hairline);
    }
    list.PopClipRect();
    if (under) show_values(theme, plot, *under, values_at(theme, plot, parts, *under, net));
    return under;
}

}  // namespace whorl::app
