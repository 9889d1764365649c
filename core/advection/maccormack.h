// The MacCormack advector.
#pragma once

#include "core/advection/predictor_corrector.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// q̂^{n+1} = A(q^n), q̂^n = Aʳ(q̂^{n+1}), q^{n+1} = q̂^{n+1} − (q̂^n − q^n)/2, limited to the nodes that enclose
/// the forward departure point.  [Selle et al. 2008; T alg 3.3] Order 2 in space and time over linear
/// semi-Lagrangian where the limiter is idle; two base steps.
struct MacCormack {
    static constexpr SchemeInfo info{"maccormack", "MacCormack", "Selle et al. 2008; thesis alg. 3.3",
                                     "Step forward and back, and add half the difference."};
    static constexpr Expansion expansion = Expansion::None;
    static constexpr bool predictor_corrector = true;
    static constexpr bool clamps_base = false;

    /// @param groups fields at the step's start, ghosts filled, and distinct ones for the result; any unit
    static void advect(const Step& step, Groups groups, std::span<Workspace> work) {
        step_forward(step, groups, work);
        half_error(step, groups, work, [&](int g, int f, Run run, Values& error) {
            const Real* forward = work[g].forward[f].row(run.j) + run.i;
            alignas(64) Values q;
            for (int k = 0; k < run.count; ++k) q[k] = forward[k] - error[k];
            finish_limited(step, groups[g], work[g], f, run, q);
        });
    }
};

}  // namespace whorl
