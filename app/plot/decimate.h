// Fewer samples that draw the same curve.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace whorl::app {

/// A sample of a curve, or a gap if `y` is NaN.
struct CurvePoint {
    std::size_t index;
    float y;
};

/// Replaces `out` by at most about 3 × `columns` points that keep every column's least and greatest sample,
/// in the samples' order, and a gap wherever a sample has no place on the axis: NaN, infinite, or not above 0
/// if `positive`. One pass over the samples; no allocation once `out` has grown.
/// @param columns  width of the curve, pixels; at least 1
void decimate(std::span<const float> y, int columns, bool positive, std::vector<CurvePoint>& out);

}  // namespace whorl::app
