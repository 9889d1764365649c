// The slopes with which a cubic is monotone.  [Fritsch and Carlson 1980; T fig 3.6]
#pragma once

#include <glm/vec2.hpp>

namespace whorl::app {

/// Whether a cubic with slopes α D and β D at its ends is monotone between them: slopes along D [T 3.15] that
/// meet one of the sufficient conditions [T 3.18, 3.19], which together are necessary.
constexpr bool is_monotone(double alpha, double beta) {
    if (alpha < 0 || beta < 0) return false;
    const double excess = alpha + beta - 2;
    const double left = 2 * alpha + beta - 3;
    const double right = alpha + 2 * beta - 3;
    if (excess <= 0 || left <= 0 || right <= 0) return true;
    return alpha - left * left / (3 * excess) >= 0;  // φ(α, β), [T 3.19c]
}

/// The region's boundary away from the axes, φ = 0: an arc of the ellipse α² + αβ + β² − 6α − 6β + 9 = 0.
/// @param part  0 at (3, 0), 1 at (0, 3)
glm::dvec2 region_boundary(double part);

}  // namespace whorl::app
