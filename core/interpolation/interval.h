// The interval of a row of samples in which a point lies.
#pragma once

namespace whorl {

/// Interval [i, i + 1] of samples 0 … last. Only schemes whose weights change near walls look at it.
struct Interval {
    int i;
    int last;
    bool periodic;
};

}  // namespace whorl
