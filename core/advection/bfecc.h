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

    /// @param groups fields at the step's start, ghosts filled, and distinct ones for the result; any unit
    static void advect(const Step& step, Groups groups, std::span<Workspace> work) {
        step_forward(step, groups, work);
        half_error(step, groups, work, [&](int g, int f, Run run, const Values& error) {
            const Real* q = groups[g].from[f]->row(run.j) + run.i;
            Real* corrected = work[g].corrected[f].row(run.j) + run.i;
            for (int k = 0; k < run.count; ++k) corrected[k] = q[k] - error[k];
        });
        std::array<Group, max_groups> again;
        for (std::size_t g = 0; g < groups.size(); ++g) {
            for (int f = 0; f < groups[g].count; ++f) {
                step.boundary->fill(work[g].corrected[f]);
                again[g].add(work[g].corrected[f], *groups[g].to[f]);
            }
        }
        step.apply(std::span(again).first(groups.size()), 1, [&](const Stepped& r) {
            limit_base(step, again[r.group], r);
            for (int f = 0; f < groups[r.group].count; ++f) {
                finish_limited(step, groups[r.group], work[r.group], f, r.run, r.q[f]);
            }
        });
    }
};

}  // namespace whorl
