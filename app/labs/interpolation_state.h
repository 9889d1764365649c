// What is chosen in the interpolation lab.
#pragma once

#include <optional>
#include <vector>

#include "app/labs/interval_report.h"
#include "app/labs/shown_interpolations.h"
#include "app/plot/plot.h"

namespace whorl::app {

struct InterpolationState {
    std::size_t data_set = 0;   ///< index into data_sets()
    std::vector<float> values;  ///< the data set's, as they have been dragged
    int interval = 0;           ///< the chosen one begins at this point
    ShownInterpolations shown = all_interpolations();
    bool clamped = false;
    std::optional<std::size_t> dragged;  ///< the point that the pointer holds
    std::optional<std::size_t> pointed;  ///< the interpolation whose row is under the pointer
    Interval y{0, 1};                    ///< of the plot, held while a point is dragged
};

/// What each interpolation does in the chosen interval.
using IntervalReports = std::vector<IntervalReport>;

/// The curves from back to front: the one that is pointed at lies over the others.
std::vector<std::size_t> drawing_order(const InterpolationState& state);

}  // namespace whorl::app
