// The inner loops of one advection, decided before it starts.
#pragma once

#include <span>

#include "core/advection/scheme_set.h"
#include "core/stencils/stencil.h"

namespace whorl {

/// Rows of what is sampled at the particles of a span: the value and, as far as the expansion goes, the
/// gradient and the cross term, one row `stride` after the other.
struct ParticleSamples {
    static constexpr int rows = 4;
    Real* values;
    std::ptrdiff_t stride;
};

/// What one particle contributes to each node of a span: its samples, and which particle it is.
struct Contribution {
    const Real* values;
    const Particle* particle;
};

/// Finds the cells that hold displaced particles, as `LocateFn`, and samples fields there: bilinear value,
/// gradient, cross term.  [T 4.1–4.3]
/// @param fields of one site; `ParticleSamples::rows` rows of `out` each
using SampleParticlesFn = void (*)(std::span<const Field* const> fields, Site nodes, NodeSpan, const Real* dx,
                                   const Real* dy, const ParticleSamples& out);
/// Adds w_s (q_s + c_s · (x_i − x_s) − q_b) of each contribution to each node's sum, where q_b is the
/// bilinear value at x_i^b: sums of differences keep a constant field constant to the last bit.  [T 4.1–4.3]
/// @param stride of the rows of samples
using AddContributionsFn = void (*)(std::span<const Contribution>, std::ptrdiff_t stride, int count,
                                    const Values& at_node, Values& sum);

struct Kernels {
    TraceFn trace;
    LocateFn locate;
    SampleFn sample;
    SampleFn sample_linear;
    SampleParticlesFn sample_particles;  ///< null where the step has no particles, as `add_contributions`
    AddContributionsFn add_contributions;
    LimitFn limit;       ///< after the whole scheme
    LimitFn limit_base;  ///< inside a predictor-corrector, after its base step; null leaves it as it is
};

/// The inner loops for a set of schemes in a domain that wraps along some axes.
Kernels choose_kernels(const SchemeSet& schemes, Wraps wraps, Isa isa = best_isa());

}  // namespace whorl
