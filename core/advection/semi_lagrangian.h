// The semi-Lagrangian advector.
#pragma once

#include "core/advection/step.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// q^{n+1}(x_i) = q^n(x_i^b): trace back, interpolate.  [Stam 1999; T alg 3.1]
/// Order 1 in time; in space the interpolation's order less one, for Δt in proportion to h. One trace and one
/// sample a node.
struct SemiLagrangian {
    static constexpr SchemeInfo info{"semi-lagrangian", "Semi-Lagrangian", "Stam 1999; thesis alg. 3.1",
                                     "Trace each node back along the flow and interpolate there."};
    static constexpr Expansion expansion = Expansion::None;
    static constexpr bool predictor_corrector = false;
    static constexpr bool clamps_base = false;

    /// @param group fields at the step's start, ghosts filled, and distinct ones for the result; any unit
    static void advect(const Step& step, const Group& group, Workspace&) {
        step.for_runs(group.shape(), [&](Run run) {
            Places at;
            step.departure(run, group.shape(), 1, at);
            for (int f = 0; f < group.count; ++f) {
                Values q;
                step.kernels.sample(*group.from[f], at, run.count, q);
                std::copy_n(q, run.count, group.to[f]->row(run.j) + run.i);
            }
        });
    }
};

}  // namespace whorl
