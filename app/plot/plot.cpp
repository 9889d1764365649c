// See plot.h.
#include "app/plot/plot.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/plot/axes.h"

namespace whorl::app {
namespace {

float text_width(const ImFont& font, std::string_view text) {
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, text.data(), text.data() + text.size()).x;
}

void add_text(ImDrawList& list, const ImFont& font, ImVec2 at, ImU32 colour, std::string_view text) {
    list.AddText(&font, font.FontSize, {std::floor(at.x), std::floor(at.y)}, colour, text.data(),
                 text.data() + text.size());
}

/// Pixel centre, where a line one pixel wide is sharp.
float sharp(float pixel) {
    return std::floor(pixel) + 0.5f;
}

/// Title on the left and legend on the right, or the legend on lines of its own if it does not fit.
/// @return the header's height
float draw_header(ImDrawList& list, const Theme& theme, const Plot& plot, std::span<const Series> series,
                  ImVec2 corner, float width) {
    const float pad = theme.px(9.0f);
    const float left = corner.x + pad;
    const float right = corner.x + width - pad;
    const float dash = theme.px(10.0f);
    const float gap = theme.px(5.0f);
    const float apart = theme.px(12.0f);
    const ImFont& body = *theme.body;
    const ImFont& small = *theme.small;
    const float title_y = corner.y + theme.px(6.0f);

    const float title_width = text_width(body, plot.title);
    add_text(list, body, {left, title_y}, theme.palette.text, plot.title);
    float title_end = left + title_width;
    if (!plot.unit.empty()) {
        const float unit_x = title_end + theme.px(6.0f);
        add_text(list, small, {unit_x, title_y + body.Ascent - small.Ascent}, theme.palette.text_dim,
                 plot.unit);
        title_end = unit_x + text_width(small, plot.unit);
    }

    float legend = -apart;
    for (const Series& one : series) legend += dash + gap + text_width(small, one.label) + apart;
    float height = theme.px(8.0f) + body.FontSize;
    if (series.empty()) return height;
    float x = right - legend;
    float y = title_y + body.Ascent - small.Ascent;
    if (x < title_end + apart) {
        x = left;
        y = corner.y + height + theme.px(3.0f);
        height += small.FontSize + theme.px(5.0f);
    }
    for (const Series& one : series) {
        const float wide = dash + gap + text_width(small, one.label);
        if (x > left && x + wide > right + 1.0f) {
            x = left;
            y += small.FontSize + theme.px(4.0f);
            height += small.FontSize + theme.px(4.0f);
        }
        const float middle = std::floor(y + 0.55f * small.FontSize);
        list.AddRectFilled({x, middle - theme.px(1.0f)}, {x + dash, middle + theme.px(1.0f)}, one.colour);
        add_text(list, small, {x + dash + gap, y}, theme.palette.text_dim, one.label);
        x += wide + apart;
    }
    return height;
}

void draw_axes(ImDrawList& list, const Theme& theme, const Frame& frame, const Ticks& x_ticks,
               const Ticks& y_ticks, float card_right) {
    const ImFont& small = *theme.small;
    for (const double value : y_ticks.values) {
        const float y = sharp(frame.to_y(value));
        list.AddLine({frame.low.x, y}, {frame.high.x, y}, theme.palette.grid);
        const std::string label = tick_label(value, y_ticks);
        add_text(list, small,
                 {frame.low.x - theme.px(6.0f) - text_width(small, label), y - 0.5f * small.FontSize},
                 theme.palette.text_dim, label);
    }
    float free_from = -FLT_MAX;
    for (const double value : x_ticks.values) {
        const float x = sharp(frame.to_x(value));
        list.AddLine({x, frame.low.y}, {x, frame.high.y}, theme.palette.grid);
        const std::string label = tick_label(value, x_ticks);
        const float wide = text_width(small, label);
        const float left = std::min(x - 0.5f * wide, card_right - theme.px(4.0f) - wide);
        if (left < free_from) continue;
        add_text(list, small, {left, frame.high.y + theme.px(4.0f)}, theme.palette.text_dim, label);
        free_from = left + wide + theme.px(8.0f);
    }
}

void draw_curve(ImDrawList& list, const Theme& theme, const Frame& frame, const Abscissa& abscissa,
                const std::vector<CurvePoint>& curve, ImU32 colour, bool dots, std::vector<ImVec2>& points) {
    // ImGui draws whole widths from a texture, several times faster than others.
    const float thickness = std::max(1.0f, theme.px(1.5f));
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
        if (std::isnan(point.y)) {
            flush();
        } else {
            points.emplace_back(frame.to_x(abscissa.at(point.index)),
                                frame.to_y(static_cast<double>(point.y)));
        }
    }
    flush();
}

void draw_hairline(ImDrawList& list, const Theme& theme, const Frame& frame, const Abscissa& abscissa,
                   std::span<const Series> series, double x) {
    if (x < frame.x.lo || x > frame.x.hi) return;
    const float pixel = sharp(frame.to_x(x));
    list.AddLine({pixel, frame.low.y}, {pixel, frame.high.y}, theme.palette.hairline);
    list.PushClipRect(frame.low, frame.high, true);
    for (const Series& one : series) {
        const std::size_t n = abscissa.count(one);
        if (n == 0 || x > abscissa.at(n - 1)) continue;
        const float y = one.y[abscissa.nearest(x, n)];
        if (!std::isfinite(y) || (frame.log_y && y <= 0.0f)) continue;
        const ImVec2 at{pixel, frame.to_y(static_cast<double>(y))};
        list.AddCircleFilled(at, theme.px(4.5f), theme.palette.card);
        list.AddCircleFilled(at, theme.px(3.0f), one.colour);
    }
    list.PopClipRect();
}

void show_values(const Theme& theme, const Plot& plot, const Abscissa& abscissa,
                 std::span<const Series> series, double x) {
    float labels = 0.0f;
    for (const Series& one : series) labels = std::max(labels, text_width(*theme.body, one.label));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(12.0f), theme.px(9.0f)));
    ImGui::BeginTooltip();
    ImGui::Text("%.*s = %s", static_cast<int>(plot.x_name.size()), plot.x_name.data(), figure(x, 6).c_str());
    for (const Series& one : series) {
        const std::size_t n = abscissa.count(one);
        const bool reached = n > 0 && x <= abscissa.at(n - 1);
        const std::string value = reached ? reading(static_cast<double>(one.y[abscissa.nearest(x, n)])) : "–";
        ImGui::PushStyleColor(ImGuiCol_Text, one.colour);
        ImGui::TextUnformatted(one.label.data(), one.label.data() + one.label.size());
        ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + labels + theme.px(12.0f));
        ImGui::TextUnformatted(value.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

}  // namespace

std::optional<double> draw_plot(const Theme& theme, const Plot& plot, std::span<const Series> series) {
    const float width =
        std::floor(std::max(1.0f, plot.size.x > 0.0f ? plot.size.x : ImGui::GetContentRegionAvail().x));
    const float height = std::floor(std::max(1.0f, plot.size.y));
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const ImVec2 corner{std::floor(cursor.x), std::floor(cursor.y)};
    const ImVec2 end{corner.x + width, corner.y + height};
    ImGui::PushID(plot.title.data(), plot.title.data() + plot.title.size());
    ImGui::InvisibleButton("plot", {width, height});
    const bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    if (!ImGui::IsRectVisible(corner, end)) return std::nullopt;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, end, theme.palette.card, theme.px(5.0f));
    list.PushClipRect(corner, end, true);
    const float header = draw_header(list, theme, plot, series, corner, width);

    const Abscissa abscissa(plot);
    // As wide as the frame can get; the y labels take some of it.
    const int columns = static_cast<int>(width);
    std::vector<std::vector<CurvePoint>> curves(series.size());
    std::size_t drawn = 0;
    for (std::size_t k = 0; k < series.size(); ++k) {
        decimate(series[k].y.first(abscissa.count(series[k])), columns, plot.log_y, curves[k]);
        for (const CurvePoint& point : curves[k]) drawn += std::isnan(point.y) ? 0u : 1u;
    }

    const float small = theme.small->FontSize;
    Frame frame{{corner.x + theme.px(9.0f), corner.y + header + theme.px(8.0f)},
                {end.x - theme.px(10.0f), end.y - small - theme.px(9.0f)},
                fit_x(plot, series),
                plot.y_range.value_or(fit_y(curves, plot.log_y)),
                plot.log_y};
    const float frame_height = frame.high.y - frame.low.y;
    std::optional<double> hovered_x;
    if (frame_height >= theme.px(24.0f) && width >= theme.px(110.0f)) {
        const auto rows = [&](float lines) {
            return std::clamp(static_cast<int>(frame_height / (lines * small)), 1, 6);
        };
        const Ticks y_ticks = plot.log_y ? log_ticks(frame.y.lo, frame.y.hi, rows(1.4f))
                                         : linear_ticks(frame.y.lo, frame.y.hi, rows(2.6f));
        float labels = 0.0f;
        for (const double value : y_ticks.values) {
            labels = std::max(labels, text_width(*theme.small, tick_label(value, y_ticks)));
        }
        // One indent for plots stacked in a column, unless a label needs more.
        frame.low.x += std::max(std::ceil(labels), theme.px(36.0f)) + theme.px(6.0f);
        const int marks = std::clamp(static_cast<int>((frame.high.x - frame.low.x) / theme.px(56.0f)), 1, 8);
        if (drawn > 0) {
            draw_axes(list, theme, frame, linear_ticks(frame.x.lo, frame.x.hi, marks), y_ticks, end.x);
        } else {
            const float wide = text_width(*theme.small, plot.empty_text);
            add_text(list, *theme.small,
                     {0.5f * (corner.x + end.x - wide), 0.5f * (frame.low.y + frame.high.y - small)},
                     theme.palette.text_dim, plot.empty_text);
        }
        // A curve's width may reach over the frame's edge by a pixel or two, so that extrema are not cut.
        const float reach = theme.px(3.0f);
        list.PushClipRect({frame.low.x - reach, frame.low.y - reach},
                          {frame.high.x + reach, frame.high.y + reach}, true);
        std::vector<ImVec2> points;
        for (std::size_t k = series.size(); k-- > 0;) {
            draw_curve(list, theme, frame, abscissa, curves[k], series[k].colour, series[k].dots, points);
        }
        list.PopClipRect();

        const float mouse = ImGui::GetIO().MousePos.x;
        if (hovered && drawn > 0 && mouse >= frame.low.x && mouse <= frame.high.x) {
            std::size_t longest = 0;
            for (const Series& one : series) longest = std::max(longest, abscissa.count(one));
            hovered_x = abscissa.at(abscissa.nearest(frame.from_x(mouse), longest));
        }
        const std::optional<double> hairline = hovered_x ? hovered_x : plot.marker;
        if (hairline) draw_hairline(list, theme, frame, abscissa, series, *hairline);
    }
    list.PopClipRect();
    if (hovered_x) show_values(theme, plot, abscissa, series, *hovered_x);
    return hovered_x;
}

}  // namespace whorl::app
