// What an interpolation says of itself, and what it must offer to be used.
#pragma once

#include <concepts>

#include "core/interpolation/interval.h"
#include "core/schemes/scheme.h"

namespace whorl {

struct InterpolationTraits {
    int samples;                ///< that it reads along an axis, 2 or 4: those next to the point
    bool bilinear = false;      ///< linear along each axis: takes them in any order, and needs no clamp
    bool overshoots;            ///< whether a value may leave the range of its interval's samples
    bool weighted_sum;          ///< whether its weights are the same whatever the samples hold
    bool approximates = false;  ///< whether it may miss the samples themselves
    int order;                  ///< in space, where nothing is limited
    int min_samples = 1;        ///< along an axis between two walls: with fewer it is not defined
};

template <class I>
concept TwoSampleInterpolation = I::traits.samples == 2 && requires(Real q) {
    { I::at(q, q, q) } -> std::same_as<Real>;
};
template <class I>
concept FourSampleInterpolation = I::traits.samples == 4 && requires(Real q, Interval in) {
    { I::at(q, q, q, q, q, in) } -> std::same_as<Real>;
};
/// Its function takes as many samples as its traits say.
template <class I>
concept InterpolationScheme = TwoSampleInterpolation<I> || FourSampleInterpolation<I>;

}  // namespace whorl
