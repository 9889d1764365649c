// The semi-Lagrangian advector.
#pragma once

#include <algorithm>

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
    using Whole = SemiLagrangian;

    /// @param groups fields at the step's start, ghosts filled, and distinct ones for the result; any unit
    static void advect(const Step& step, Groups groups, std::span<Workspace>) {
        step.apply(groups, 1, [&](const Stepped& r) {
            const Group& group = groups[r.group];
            for (int f = 0; f < group.count; ++f) {
                std::copy_n(r.q[f], r.run.count, group.to[f]->row(r.run.j) + r.run.i);
            }
        });
    }
};

}  // namespace whorl
