// The plot widget: curves over steps or anything else, with axes, legend and the values under the pointer.
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "app/render/theme.h"

namespace whorl::app {

/// One curve. Samples that are NaN or infinite leave a gap.
struct Series {
    std::string_view label;
    ImU32 colour;
    std::span<const float> y;
    bool dots = false;              ///< marks the samples too, where they lie apart
    std::span<const float> x = {};  ///< where they lie, ascending; empty takes the plot's
};

/// A point marked over the curves.
struct PlotMark {
    double x, y;
    ImU32 colour;
    float radius;        ///< points
    bool filled = true;  ///< else a ring
};

/// An interval of an axis.
struct Interval {
    double lo;
    double hi;
};

/// What a plot shows. Samples lie at `x_first + k · x_stride`, or at `x[k]` (ascending) if `x` is not empty.
struct Plot {
    std::string_view title;
    std::string_view unit = {};        ///< of y, behind the title
    std::string_view x_name = "step";  ///< at the end of the axis, and in the tooltip
    std::string_view x_unit = {};      ///< behind the name at the axis
    double x_first = 0.0;
    double x_stride = 1.0;  ///< positive
    std::span<const float> x = {};
    bool log_x = false;                    ///< samples at x not above 0 leave a gap; all others are drawn
    bool log_y = false;                    ///< values not above 0 leave a gap
    std::optional<Interval> y_range = {};  ///< fitted to the curves if empty
    std::optional<double> marker = {};     ///< hairline where another plot is hovered
    std::span<const PlotMark> marks = {};
    ImVec2 size = {0.0f, 160.0f};  ///< of the card, pixels; no width takes all there is
    std::string_view empty_text = "no samples yet";
    bool legend = true;  ///< names the curves on the card; the tooltip does so anyway
};

/// Draws a card at ImGui's cursor and advances it. A curve costs a pass over its samples (10 µs for 10,000)
/// and draws at most two points a pixel column. The legend wraps beside or below the title, and gives way
/// where it would leave the curves no room. The tooltip lists the curves from top to bottom.
/// @param away  gets how far from the pointer each curve passes, pixels, where there is a sample under it
/// @return x of the sample under the pointer, if any: pass it to the other plots as `marker`
std::optional<double> draw_plot(const Theme& theme, const Plot& plot, std::span<const Series> series,
                                std::vector<float>* away = nullptr);

/// Draws the same card, `plot.size` pixels large, anywhere: for pictures.
void paint_plot(ImDrawList& list, const Theme& theme, const Plot& plot, std::span<const Series> series,
                ImVec2 corner);

}  // namespace whorl::app
