// The interval of a row of samples in which a point lies.
#pragma once

#include "core/parallel/simd.h"

namespace whorl {

/// Interval [i, i + 1] of samples 0 … last, for one point or for a vector of them. Only schemes whose weights
/// change near walls look at it.
template <class T>
struct IntervalOf {
    IndexOf<T> i;
    int last;
    bool wraps;
};
using Interval = IntervalOf<Real>;

/// T, left to be deduced from another argument.
template <class T>
using SameAs = std::type_identity_t<T>;
/// The interval that goes with points of type T; T is then deduced from the samples alone.
template <class T>
using IntervalFor = std::type_identity_t<IntervalOf<T>>;

}  // namespace whorl
