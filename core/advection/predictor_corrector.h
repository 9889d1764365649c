// The first two steps that MacCormack and BFECC share: forward, and back again.
#pragma once

#include <algorithm>

#include "core/advection/step.h"

namespace whorl {

/// Limits the base step inside a predictor-corrector, where its scheme asks for that.
inline void limit_base(const Step& step, const Group& from, const StepResult& r) {
    if (step.kernels.limit_base == nullptr) return;
    for (int f = 0; f < from.count; ++f) {
        step.kernels.limit_base(*from.from[f], r.at.at, r.nodes.count, r.first_order[f], r.q[f]);
    }
}

/// q̂^{n+1} = A(q^n) into the workspaces, ghosts filled, and the cells of the departure points.
inline void step_forward(const Step& step, Groups groups, std::span<Workspace> work) {
    for (std::size_t g = 0; g < groups.size(); ++g) work[g].shape_like(groups[g]);
    step.apply(groups, 1, [&](const StepResult& r) {
        const Group& group = groups[r.group];
        Workspace& to = work[r.group];
        limit_base(step, group, r);
        for (int f = 0; f < group.count; ++f) {
            std::copy_n(r.q[f], r.nodes.count, to.forward[f].row(r.nodes.j) + r.nodes.i);
        }
        std::copy_n(r.at.at, r.nodes.count, to.departures(r.nodes, group.shape()));
    });
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (int f = 0; f < groups[g].count; ++f) step.boundary->fill(work[g].forward[f]);
    }
}

/// Takes the error e = (q̂^n − q^n)/2, where q̂^n = Aʳ(q̂^{n+1}), to `use(g, f, nodes, e)` for each field f of
/// each group g.
template <class Use>
void half_error(const Step& step, Groups groups, std::span<Workspace> work, Use&& use) {
    std::array<Group, max_groups> back;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (int f = 0; f < groups[g].count; ++f) back[g].add(work[g].forward[f], *groups[g].to[f]);
    }
    step.apply(std::span(back).first(groups.size()), -1, [&](const StepResult& r) {
        limit_base(step, back[r.group], r);
        for (int f = 0; f < groups[r.group].count; ++f) {
            const Real* q = groups[r.group].from[f]->row(r.nodes.j) + r.nodes.i;
            Values& error = r.q[f];
            for (int k = 0; k < r.nodes.count; ++k) error[k] = (error[k] - q[k]) * Real(0.5);
            use(r.group, f, r.nodes, error);
        }
    });
}

/// Limits new values to the nodes of q^n that enclose the forward departure points, and writes them.
inline void finish_limited(const Step& step, const Group& group, Workspace& work, int f, NodeSpan nodes,
                           Values& q) {
    alignas(64) Values forward;
    std::copy_n(work.forward[f].row(nodes.j) + nodes.i, nodes.count, forward);
    step.kernels.limit(*group.from[f], work.departures(nodes, group.shape()), nodes.count, forward, q);
    std::copy_n(q, nodes.count, group.to[f]->row(nodes.j) + nodes.i);
}

}  // namespace whorl
