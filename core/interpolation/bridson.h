// Bridson's cubic interpolation.
#pragma once

#include "core/grid/real.h"
#include "core/interpolation/interval.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// The cubic through four samples (Lagrange).  [T A.10]
/// Order 4 in space; overshoots.
struct Bridson {
    static constexpr SchemeInfo info{"bridson", "Bridson cubic", "Bridson 2008; thesis eq. A.10",
                                     "The cubic through the four nearest samples. Sharp, but overshoots."};
    static constexpr int support = 4;
    static constexpr bool overshoots = true;

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       place in [i, i + 1], 0 to 1
    static Real at(Real qm, Real q0, Real q1, Real q2, Real t, Interval) {
        const Real t2 = t * t;
        const Real t3 = t2 * t;
        const Real wm = t2 / 2 - t / 3 - t3 / 6;
        const Real w1 = t + (t2 - t3) / 2;
        const Real w2 = (t3 - t) / 6;
        // w0 is 1 less the others; written as differences from q0, so that a constant stays itself.
        return q0 + wm * (qm - q0) + w1 * (q1 - q0) + w2 * (q2 - q0);
    }
};

}  // namespace whorl
