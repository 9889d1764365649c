// Curves of every interpolation between data points.
#pragma once

#include "app/labs/canvas.h"
#include "app/labs/interpolation_state.h"

namespace whorl::app {

/// A curve of each interpolation of the registry, at the same places.
struct InterpolationCurves {
    std::vector<float> x;
    std::vector<std::vector<float>> y;
};

/// Every interpolation of a row between two of its points.
InterpolationCurves curves_of(const Field& row, bool clamped, int first, int last);

/// Around the curves that are shown.
Extent extent_of(const InterpolationState& lab, const InterpolationCurves& curves);

/// Curves that lie on each other take turns, so that each of them is seen: as dashes in their colours.
void draw_curves(const Theme& theme, const InterpolationState& lab, const Canvas& canvas,
                 const InterpolationCurves& curves);

void draw_points(const Theme& theme, const InterpolationState& lab, const Canvas& canvas);

}  // namespace whorl::app
