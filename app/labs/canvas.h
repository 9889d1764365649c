// A plot's card and axes to draw on by hand.
#pragma once

#include <imgui.h>

#include <cfloat>
#include <optional>
#include <span>

#include "app/plot/card.h"

namespace whorl::app {

/// Takes a card's place at ImGui's cursor, draws it with its axes, and turns values into pixels. The card is
/// the last ImGui item as long as nothing else is added.
class Canvas {
  public:
    enum class Units {
        Free,
        Equal  ///< one unit is as long on both axes: an interval is widened
    };

    Canvas(const Theme& theme, const Plot& plot, std::span<const LegendEntry> legend, Interval x, Interval y,
           Units units = Units::Free);

    /// Whether there is room to draw at all; nothing below may be called otherwise.
    explicit operator bool() const { return axes_.has_value(); }
    const Frame& frame() const { return axes_->frame; }
    /// Whether the pointer is over the frame.
    bool hovered() const;
    /// Whether a button went down on the card in this frame, and whether one is held since.
    bool pressed() const { return pressed_; }
    bool held() const { return held_; }
    /// The value under the pointer, in or out of the frame.
    double pointer_x() const;
    double pointer_y() const;
    ImVec2 pixel(double x, double y) const { return {frame().to_x(x), frame().to_y(y)}; }

    /// A line through samples; NaN leaves a gap.
    void curve(std::span<const float> x, std::span<const float> y, ImU32 colour, float thickness) const;
    /// A dot of a radius in pixels, over a rim of the card's colour.
    void dot(double x, double y, float radius, ImU32 colour) const;
    /// A dot without a rim, where many lie side by side.
    void mark(double x, double y, float radius, ImU32 colour) const;
    void ring(double x, double y, float radius, ImU32 colour) const;
    /// The frame's height between two values of x.
    void band(double x_first, double x_last, ImU32 colour) const;
    /// Dashes through pixels.
    void dashes(std::span<const ImVec2> points, ImU32 colour) const;
    /// The list of values at a place under the pointer.
    void values(double x, std::span<const ValueRow> rows) const { show_values(theme_, plot_, x, rows); }

    /// The list, cut to the frame and a little more between these.
    ImDrawList& begin() const;
    void end() const { list_.PopClipRect(); }

  private:
    const Theme& theme_;
    Plot plot_;
    ImDrawList& list_;
    Card card_;
    std::optional<Axes> axes_;
    bool pressed_ = false, held_ = false;
};

/// An interval of y around values, with some air; NaN are passed over.
class Extent {
  public:
    void add(std::span<const float> values);
    /// With 0 where the values come near it.
    Interval fitted() const;
    /// The values alone.
    Interval tight() const;

  private:
    float least_ = FLT_MAX, most_ = -FLT_MAX;
};

}  // namespace whorl::app
