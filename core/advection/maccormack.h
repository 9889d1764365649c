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

    /// @param group fields at the step's start, ghosts filled, and distinct ones for the result; any unit
    static void advect(const Step& step, const Group& group, Workspace& work) {
        step_forward(step, group, work);
        step.for_runs(group.shape(), [&](Run run) {
            GroupValues error;
            half_error(step, group, work, run, error);
            Places at;
            step.departure(run, group.shape(), 1, at);
            for (int f = 0; f < group.count; ++f) {
                Values forward, q;
                std::copy_n(work.forward[f].row(run.j) + run.i, run.count, forward);
                for (int k = 0; k < run.count; ++k) q[k] = forward[k] - error[f][k];
                step.kernels.limit(*group.from[f], at, run.count, forward, q);
                std::copy_n(q, run.count, group.to[f]->row(run.j) + run.i);
            }
        });
    }
};

}  // namespace whorl
