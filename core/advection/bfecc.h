// The back and forth error compensation and correction advector.
#pragma once

#include "core/advection/predictor_corrector.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// q̂^{n+1} = A(q^n), q̂^n = Aʳ(q̂^{n+1}), q̃^n = q^n − (q̂^n − q^n)/2, q^{n+1} = A(q̃^n), limited to the nodes of
/// q^n that enclose the forward departure point.  [Dupont and Liu 2003; T alg 3.2] Order 2 in space and time
/// over linear semi-Lagrangian where the limiter is idle; three base steps.
struct Bfecc {
    static constexpr SchemeInfo info{
        "bfecc", "BFECC", "Dupont and Liu 2003; thesis alg. 3.2",
        "Step forward and back, correct the start by half the difference, step again."};
    static constexpr Expansion expansion = Expansion::None;
    static constexpr bool predictor_corrector = true;
    static constexpr bool clamps_base = false;

    /// @param group fields at the step's start, ghosts filled, and distinct ones for the result; any unit
    static void advect(const Step& step, const Group& group, Workspace& work) {
        step_forward(step, group, work);
        step.for_runs(group.shape(), [&](Run run) {
            GroupValues error;
            half_error(step, group, work, run, error);
            for (int f = 0; f < group.count; ++f) {
                const Real* q = group.from[f]->row(run.j) + run.i;
                Real* corrected = work.corrected[f].row(run.j) + run.i;
                for (int k = 0; k < run.count; ++k) corrected[k] = q[k] - error[f][k];
            }
        });
        Group again;
        for (int f = 0; f < group.count; ++f) {
            step.boundary->fill(work.corrected[f]);
            again.add(work.corrected[f], *group.to[f]);
        }
        step.for_runs(group.shape(), [&](Run run) {
            Places at;
            GroupValues q, first_order;
            step.departure(run, group.shape(), 1, at);
            step.base(run, again, at, 1, q, first_order);
            for (int f = 0; f < group.count; ++f) {
                if (step.kernels.limit_base) {
                    step.kernels.limit_base(*again.from[f], at, run.count, first_order[f], q[f]);
                }
                Values reverted;
                std::copy_n(work.forward[f].row(run.j) + run.i, run.count, reverted);
                step.kernels.limit(*group.from[f], at, run.count, reverted, q[f]);
                std::copy_n(q[f], run.count, group.to[f]->row(run.j) + run.i);
            }
        });
    }
};

}  // namespace whorl
