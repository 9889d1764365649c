// Cubic B-spline approximation.
#pragma once

#include "core/grid/real.h"
#include "core/interpolation/interval.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// Weights from the cubic B-spline's basis functions; near a box's walls those of boundary and external
/// samples. [T A.3 table]  Approximating: the curve does not pass through the samples, so each step smooths.
/// Order 2 in space; stays in the range of the four samples, not of the enclosing two.
struct BSpline {
    static constexpr SchemeInfo info{
        "b-spline", "Cubic B-spline", "Steffen et al. 2008; thesis table A.3",
        "Approximates instead of interpolating, so that even a step at rest blurs."};
    static constexpr int support = 4;
    static constexpr bool overshoots = true;
    /// Fewer samples than this between two walls have no internal row in the table.
    static constexpr int min_samples = 4;

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       place in [i, i + 1], 0 to 1
    static Real at(Real qm, Real q0, Real q1, Real q2, Real t, Interval at) {
        if (!at.periodic) {
            if (at.last == 0 || at.i < 0) return q1;
            if (at.i >= at.last) return q0;
            if (at.i <= 1) return near_wall(qm, q0, q1, q2, t, at.i);
            if (at.i >= at.last - 2) return near_wall(q2, q1, q0, qm, 1 - t, at.last - 1 - at.i);
        }
        return rising(t) * q2 + centre(t - 1) * q1 + centre(-t) * q0 + rising(1 - t) * qm;
    }

  private:
    /// The internal basis function on [−2, −1], x + 2 = t.
    static Real rising(Real t) { return t * t * t / 6; }
    /// The internal basis function on [−1, 0].
    static Real centre(Real x) { return (4 - 3 * x * x * (x + 2)) / 6; }

    /// Intervals 0 and 1 from a wall at the left: samples 0 (boundary) and 1 (external) have rows of their
    /// own.
    static Real near_wall(Real qm, Real q0, Real q1, Real q2, Real t, int interval) {
        const Real s = 1 - t;
        if (interval == 0) {
            const Real boundary = Real(1.5) * t * t * (t / 2 - 1) + 1;
            const Real external = t * t * (7 - 11 * (t - 1)) / 12;
            return boundary * q0 + external * q1 + rising(t) * q2;
        }
        const Real boundary = s * s * s / 4;
        const Real external = (7 * (t * t * t + 1) + 3 * t * (1 - 5 * t)) / 12;
        return boundary * qm + external * q0 + centre(t - 1) * q1 + rising(t) * q2;
    }
};

}  // namespace whorl
