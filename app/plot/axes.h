// From values to pixels: the two axes of a plot.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "app/plot/decimate.h"
#include "app/plot/plot.h"
#include "app/plot/ticks.h"

namespace whorl::app {

/// Where samples lie in x.
class Abscissa {
  public:
    explicit Abscissa(const Plot& plot) : plot_(plot) {}

    double at(std::size_t k) const {
        return plot_.x.empty() ? plot_.x_first + static_cast<double>(k) * plot_.x_stride
                               : static_cast<double>(plot_.x[k]);
    }
    /// Number of samples of a curve that have an x.
    std::size_t count(const Series& series) const {
        return plot_.x.empty() ? series.y.size() : std::min(series.y.size(), plot_.x.size());
    }
    /// The sample of `n` (at least one) nearest to x.
    std::size_t nearest(double x, std::size_t n) const;

  private:
    const Plot& plot_;
};

/// A rectangle of pixels that shows an interval of x and one of y.
struct Frame {
    ImVec2 low;   ///< top left
    ImVec2 high;  ///< bottom right
    Interval x;
    Interval y;
    bool log_y;

    float to_x(double value) const;
    float to_y(double value) const;
    double from_x(float pixel) const;
};

/// The interval of x that the longest curve spans, at least one stride.
Interval fit_x(const Plot& plot, std::span<const Series> series);

/// A y interval around all points: from 0 if they come near it, some air above, never empty.
Interval fit_y(std::span<const std::vector<CurvePoint>> curves, bool log_y);

}  // namespace whorl::app
