#include "app/labs/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace whorl::app {
namespace {

void widen(Interval& interval, double length) {
    const double more = 0.5 * (length - (interval.hi - interval.lo));
    interval = {interval.lo - more, interval.hi + more};
}

}  // namespace

Canvas::Canvas(const Theme& theme, const Plot& plot, std::span<const LegendEntry> legend, Interval x,
               Interval y, Units units)
    : theme_(theme), plot_(plot), list_(*ImGui::GetWindowDrawList()), card_(place_card(plot)) {
    pressed_ = ImGui::IsItemActivated();
    held_ = ImGui::IsItemActive();
    if (!card_.visible) return;
    list_.PushClipRect(card_.low, card_.high, true);
    const float top = draw_card(list_, theme, plot, legend, card_);
    axes_ = lay_out_axes(theme, plot, card_, top, x, y);
    if (axes_ && units == Units::Equal) {
        const Frame& f = axes_->frame;
        const auto wide = static_cast<double>(f.high.x - f.low.x);
        const auto high = static_cast<double>(f.high.y - f.low.y);
        const double unit = std::max((x.hi - x.lo) / wide, (y.hi - y.lo) / high);
        widen(x, unit * wide);
        widen(y, unit * high);
        axes_ = lay_out_axes(theme, plot, card_, top, x, y);
    }
    if (axes_) draw_axes(list_, theme, plot, *axes_, card_);
    list_.PopClipRect();
}

bool Canvas::hovered() const {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Frame& f = frame();
    return card_.hovered && mouse.x >= f.low.x && mouse.x <= f.high.x && mouse.y >= f.low.y &&
           mouse.y <= f.high.y;
}

double Canvas::pointer_x() const {
    return frame().from_x(ImGui::GetIO().MousePos.x);
}

double Canvas::pointer_y() const {
    const Frame& f = frame();
    const auto part = static_cast<double>((f.high.y - ImGui::GetIO().MousePos.y) / (f.high.y - f.low.y));
    return f.y.lo + part * (f.y.hi - f.y.lo);
}

ImDrawList& Canvas::begin() const {
    const float reach = theme_.px(3);  // so that extrema are not cut
    list_.PushClipRect({frame().low.x - reach, frame().low.y - reach},
                       {frame().high.x + reach, frame().high.y + reach}, true);
    return list_;
}

void Canvas::curve(std::span<const float> x, std::span<const float> y, ImU32 colour, float thickness) const {
    std::vector<ImVec2> points;
    const auto flush = [&] {
        if (points.size() > 1)
            list_.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_None,
                              thickness);
        points.clear();
    };
    begin();
    for (std::size_t k = 0; k < y.size(); ++k) {
        if (std::isfinite(y[k])) {
            points.push_back(pixel(static_cast<double>(x[k]), static_cast<double>(y[k])));
        } else {
            flush();
        }
    }
    flush();
    end();
}

void Canvas::dot(double x, double y, float radius, ImU32 colour) const {
    begin();
    list_.AddCircleFilled(pixel(x, y), radius + theme_.px(1.5f), theme_.palette.card);
    list_.AddCircleFilled(pixel(x, y), radius, colour);
    end();
}

void Canvas::mark(double x, double y, float radius, ImU32 colour) const {
    begin().AddCircleFilled(pixel(x, y), radius, colour);
    end();
}

void Canvas::ring(double x, double y, float radius, ImU32 colour) const {
    begin();
    list_.AddCircle(pixel(x, y), radius, colour, 0, theme_.px(1.5f));
    end();
}

void Canvas::band(double x_first, double x_last, ImU32 colour) const {
    list_.AddRectFilled({frame().to_x(x_first), frame().low.y}, {frame().to_x(x_last), frame().high.y},
                        colour);
}

void Canvas::dashes(std::span<const ImVec2> points, ImU32 colour) const {
    begin();
    const float dash = theme_.px(5);
    float gone = 0;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const ImVec2 way{points[k].x - points[k - 1].x, points[k].y - points[k - 1].y};
        const float length = std::hypot(way.x, way.y);
        for (float from = 0; from < length;) {
            const float in_pair = std::fmod(gone, 2 * dash);
            const bool on = in_pair < dash;
            // At least a part of a pixel, lest rounding keep it in place.
            const float to = std::min(length, from + std::max(0.1f, (on ? dash : 2 * dash) - in_pair));
            if (on)
                list_.AddLine(
                    {points[k - 1].x + way.x * from / length, points[k - 1].y + way.y * from / length},
                    {points[k - 1].x + way.x * to / length, points[k - 1].y + way.y * to / length}, colour,
                    theme_.px(1.5f));
            gone += to - from;
            from = to;
        }
    }
    end();
}

void Extent::add(std::span<const float> values) {
    for (const float value : values) {
        if (!std::isfinite(value)) continue;
        least_ = std::min(least_, value);
        most_ = std::max(most_, value);
    }
}

Interval Extent::fitted() const {
    std::array<std::vector<CurvePoint>, 1> ends;
    if (least_ <= most_) ends[0] = {{0, least_}, {1, most_}};
    return fit_y(ends, false);
}

Interval Extent::tight() const {
    // Rounding alone is nothing to look at closely.
    if (!(most_ - least_ > 1e-5f * std::max(std::abs(least_), std::abs(most_)))) return fitted();
    const double air = 0.08 * static_cast<double>(most_ - least_);
    return {static_cast<double>(least_) - air, static_cast<double>(most_) + air};
}

}  // namespace whorl::app
