// What an interpolation is: an entry of a list, apart from its body.
#pragma once

#include <array>

#include "core/base/id.h"
#include "core/base/scheme_info.h"
#include "core/grid/sides.h"
#include "core/interpolation/hermite.h"
#include "core/interpolation/interval.h"
#include "core/sampling/node_span.h"

namespace whorl {

/// What a scheme says of itself.
struct InterpolationTraits {
    int samples;                ///< that it reads along an axis, 2 or 4: those next to the point
    bool bilinear = false;      ///< linear along each axis: takes them in any order, and needs no clamp
    bool overshoots;            ///< whether a value may leave the range of its interval's samples
    bool weighted_sum;          ///< whether its weights are the same whatever the samples hold
    bool approximates = false;  ///< whether it may miss the samples themselves
    int order;                  ///< in space, where nothing is limited
    int min_samples = 1;        ///< along an axis between two walls: with fewer it is not defined
};

/// Interpolates a field at points in its cells.
using SampleFn = void (*)(const Field&, const CellPositions&, int count, Values& out);

/// What a loop over points is made for.
struct SampleOptions {
    bool x_first = true;   ///< along x, then along y; or the other way
    bool clamped = false;  ///< to the enclosing samples  [T 3.8]
    Wraps wraps{};
};

struct Interpolation {
    SchemeInfo info;
    InterpolationTraits traits;

    /// The loop for points in the plane.
    SampleFn (*sample)(const SampleOptions&, Isa);
    /// One axis: the value at t (0 to 1) in the interval between q[1] and q[2], of samples i − 1 … i + 2.
    Real (*at)(const std::array<Real, 4>& q, Real t, const Interval& interval);
    /// Of a cubic in Hermite form, the slopes that it takes in place of central ones; else null.
    Slopes<Real> (*limited)(const Slopes<Real>&);

    /// All interpolations; the first is the default.
    static Registry<Interpolation>& list();
};

/// What the particles of a step are sampled with, whatever interpolation is chosen.
extern const Interpolation linear;

}  // namespace whorl
