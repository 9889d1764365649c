// What every plot has: a card with title, legend, axes and a list of the values under the pointer.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/plot/axes.h"
#include "app/plot/plot.h"
#include "app/plot/ticks.h"

namespace whorl::app {

/// A card's place, pixels.
struct Card {
    ImVec2 low;  ///< top left
    ImVec2 high;
    bool hovered = false;
    bool visible = true;  ///< not scrolled away
};

/// A name in a legend.
struct LegendEntry {
    std::string_view label;
    ImU32 colour;
    bool area = false;  ///< a square rather than a dash before it
};

/// A line of the tooltip.
struct ValueRow {
    std::string_view label;
    ImU32 colour;
    std::optional<double> value;  ///< none where the curve does not reach
};

/// Takes the card's place at ImGui's cursor and advances it.
Card place_card(const Plot& plot);

/// Draws the card itself, its title, and the legend beside it or on lines of its own.
/// @return where the curves may begin, pixels from the top of the screen
float draw_card(ImDrawList& list, const Theme& theme, const Plot& plot, std::span<const LegendEntry> legend,
                const Card& card);

/// A frame and the numbers at its sides.
struct Axes {
    Frame frame;
    Ticks x;
    Ticks y;
};

/// The largest frame that leaves room for its numbers, or none if the card is too small for any.
/// @param top   where it may begin, as draw_card gave it
std::optional<Axes> lay_out_axes(const Theme& theme, const Plot& plot, const Card& card, float top,
                                 Interval x, Interval y);

/// Draws grid lines, numbers, and at the end of the x axis its name, for which numbers give way.
void draw_axes(ImDrawList& list, const Theme& theme, const Plot& plot, const Axes& axes, const Card& card);

/// Says in the frame's middle that there is nothing to show.
void draw_emptiness(ImDrawList& list, const Theme& theme, const Plot& plot, const Frame& frame,
                    const Card& card);

/// The vertical line under the pointer.
/// @return its pixel, or none if x is not in the frame
std::optional<float> draw_hairline(ImDrawList& list, const Theme& theme, const Frame& frame, double x);

/// The x under the mouse, if the card is hovered there.
std::optional<double> hovered_x(const Card& card, const Frame& frame);

/// The list of values under the pointer.
void show_values(const Theme& theme, const Plot& plot, double x, std::span<const ValueRow> rows);

/// Pixel centre, where a line one pixel wide is sharp.
float sharp(float pixel);

/// A curve's width, pixels: ImGui draws whole widths from a texture, several times faster than others.
float curve_thickness(const Theme& theme);

}  // namespace whorl::app
