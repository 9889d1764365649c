// The MacCormack advector.
#include "core/advection/predictor_corrector.h"
#include "core/advection/stateless.h"

namespace whorl {
namespace {

/// q̂^{n+1} = A(q^n), q̂^n = Aʳ(q̂^{n+1}), q^{n+1} = q̂^{n+1} − (q̂^n − q^n)/2, limited to the nodes that enclose
/// the forward departure point.  [Selle et al. 2008; T alg 3.3] Order 2 in space and time over linear
/// semi-Lagrangian where the limiter is idle; two base steps.
void advect(const Step& step, Groups groups, std::span<Workspace> work) {
    step_forward(step, groups, work);
    half_error(step, groups, work, [&](int g, int f, NodeSpan nodes, Values& error) {
        const Real* forward = work[g].forward[f].row(nodes.j) + nodes.i;
        alignas(64) Values q;
        for (int k = 0; k < nodes.count; ++k) q[k] = forward[k] - error[k];
        finish_limited(step, groups[g], work[g], f, nodes, q);
    });
}

}  // namespace

extern constinit const Advector maccormack{
    .info{"maccormack", "MacCormack", "Selle et al. 2008; thesis alg. 3.3",
          "Step forward and back, and add half the difference."},
    .traits{.base_step = true, .limited = true},
    .make = stateless<advect>};

}  // namespace whorl
