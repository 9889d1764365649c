// The first two steps that MacCormack and BFECC share: forward, and back again.
#pragma once

#include "core/advection/step.h"

namespace whorl {

/// q̂^{n+1} = A(q^n) into the workspace, ghosts filled.
inline void step_forward(const Step& step, const Group& group, Workspace& work) {
    work.shape_like(group);
    step.for_runs(group.shape(), [&](Run run) {
        Places at;
        GroupValues q, first_order;
        step.departure(run, group.shape(), 1, at);
        step.base(run, group, at, 1, q, first_order);
        for (int f = 0; f < group.count; ++f) {
            if (step.kernels.limit_base) {
                step.kernels.limit_base(*group.from[f], at, run.count, first_order[f], q[f]);
            }
            std::copy_n(q[f], run.count, work.forward[f].row(run.j) + run.i);
        }
    });
    for (int f = 0; f < group.count; ++f) step.boundary->fill(work.forward[f]);
}

/// The error e = (q̂^n − q^n)/2 of a run, where q̂^n = Aʳ(q̂^{n+1}).
inline void half_error(const Step& step, const Group& group, const Workspace& work, Run run,
                       GroupValues& error) {
    Group back;
    for (int f = 0; f < group.count; ++f) back.add(work.forward[f], *group.to[f]);
    Places at;
    GroupValues first_order;
    step.departure(run, group.shape(), -1, at);
    step.base(run, back, at, -1, error, first_order);
    for (int f = 0; f < group.count; ++f) {
        if (step.kernels.limit_base) {
            step.kernels.limit_base(*back.from[f], at, run.count, first_order[f], error[f]);
        }
        const Real* q = group.from[f]->row(run.j) + run.i;
        for (int k = 0; k < run.count; ++k) error[f][k] = (error[f][k] - q[k]) * Real(0.5);
    }
}

}  // namespace whorl
