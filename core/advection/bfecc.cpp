// The back and forth error compensation and correction advector.
#include "core/advection/predictor_corrector.h"
#include "core/advection/stateless.h"

namespace whorl {
namespace {

/// q̂^{n+1} = A(q^n), q̂^n = Aʳ(q̂^{n+1}), q̃^n = q^n − (q̂^n − q^n)/2, q^{n+1} = A(q̃^n), limited to the nodes of
/// q^n that enclose the forward departure point.  [Dupont and Liu 2003; T alg 3.2] Order 2 in space and time
/// over linear semi-Lagrangian where the limiter is idle; three base steps.
void advect(const Step& step, Groups groups, std::span<Workspace> work) {
    step_forward(step, groups, work);
    half_error(step, groups, work, [&](int g, int f, NodeSpan nodes, const Values& error) {
        const Real* q = groups[g].from[f]->row(nodes.j) + nodes.i;
        Real* corrected = work[g].corrected[f].row(nodes.j) + nodes.i;
        for (int k = 0; k < nodes.count; ++k) corrected[k] = q[k] - error[k];
    });
    std::array<Group, max_groups> again;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        for (int f = 0; f < groups[g].count; ++f) {
            step.boundary->fill(work[g].corrected[f]);
            again[g].add(work[g].corrected[f], *groups[g].to[f]);
        }
    }
    step.apply(std::span(again).first(groups.size()), 1, [&](const StepResult& r) {
        limit_base(step, again[r.group], r);
        for (int f = 0; f < groups[r.group].count; ++f) {
            finish_limited(step, groups[r.group], work[r.group], f, r.nodes, r.q[f]);
        }
    });
}

}  // namespace

extern constinit const Advector bfecc{
    .info{"bfecc", "BFECC", "Dupont and Liu 2003; thesis alg. 3.2",
          "Step forward and back, correct the start by half the difference, step again."},
    .traits{.base_step = true, .limited = true},
    .make = stateless<advect>};

}  // namespace whorl
