// What a scheme that can make new extrema does about them.
#pragma once

#include <algorithm>

#include "core/grid/real.h"
#include "core/schemes/scheme.h"

namespace whorl {

struct ClampLimiter {
    static constexpr SchemeInfo info{"clamp", "Clamp", "thesis sec. 3.2, eq. 3.8",
                                     "New extrema are cut to the nodes that enclose the departure point."};
    static Real limit(Real value, Real, Real low, Real high) { return std::min(std::max(value, low), high); }
};
struct RevertLimiter {
    static constexpr SchemeInfo info{"revert", "Revert", "Selle et al. 2008",
                                     "Where a new extremum would appear, the first-order result is taken."};
    static Real limit(Real value, Real first_order, Real low, Real high) {
        return value < low || value > high ? first_order : value;
    }
};
struct NoLimiter {
    static constexpr SchemeInfo info{"none", "None", "", "New extrema are left as they come."};
    static Real limit(Real value, Real, Real, Real) { return value; }
};

}  // namespace whorl
