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

/// Where the samples of a curve lie in x.
class Abscissa {
  public:
    Abscissa(const Plot& plot, const Series& series)
        : x_(series.x.empty() ? plot.x : series.x),
          first_(plot.x_first),
          stride_(plot.x_stride),
          count_(x_.empty() ? series.y.size() : std::min(series.y.size(), x_.size())) {}

    double at(std::size_t k) const {
        return x_.empty() ? first_ + static_cast<double>(k) * stride_ : static_cast<double>(x_[k]);
    }
    /// Number of samples that have an x.
    std::size_t count() const { return count_; }
    /// Whether the curve reaches over x.
    bool spans(double x) const { return count_ > 0 && x >= at(0) && x <= at(count_ - 1); }
    /// The sample nearest to x. @pre count() > 0
    std::size_t nearest(double x) const;

  private:
    std::span<const float> x_;
    double first_;
    double stride_;
    std::size_t count_;
};

/// A rectangle of pixels that shows an interval of x and one of y.
struct Frame {
    ImVec2 low;   ///< top left
    ImVec2 high;  ///< bottom right
    Interval x;
    Interval y;
    bool log_x;
    bool log_y;

    /// Not finite where a value has no place on the axis.
    float to_x(double value) const;
    float to_y(double value) const;
    double from_x(float pixel) const;
};

/// The interval of x that all curves span, at least one stride.
Interval fit_x(const Plot& plot, std::span<const Series> series);

/// A y interval around all points: from 0 if they come near it, some air above, never empty.
Interval fit_y(std::span<const std::vector<CurvePoint>> curves, bool log_y);

/// The x nearest to `x` at which a curve has a sample. @pre a curve has samples
double nearest_sample(const Plot& plot, std::span<const Series> series, double x);

}  // namespace whorl::app
