// What a scheme that can make new extrema does about them.
#pragma once

#include "core/parallel/lanes.h"
#include "core/schemes/scheme.h"

namespace whorl {

struct ClampLimiter {
    static constexpr SchemeInfo info{"clamp", "Clamp", "thesis sec. 3.2, eq. 3.8",
                                     "New extrema are cut to the nodes that enclose the departure point."};
    template <class T>
    static WHORL_INLINE T limit(T value, T, T low, T high) {
        return smaller(larger(value, low), high);
    }
};
struct RevertLimiter {
    static constexpr SchemeInfo info{"revert", "Revert", "Selle et al. 2008",
                                     "Where a new extremum would appear, the first-order result is taken."};
    template <class T>
    static WHORL_INLINE T limit(T value, T first_order, T low, T high) {
        return select(value < low, first_order, select(value > high, first_order, value));
    }
};
struct NoLimiter {
    static constexpr SchemeInfo info{"none", "None", "", "New extrema are left as they come."};
    template <class T>
    static WHORL_INLINE T limit(T value, T, T, T) {
        return value;
    }
};

}  // namespace whorl
