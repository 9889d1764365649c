// The semi-Lagrangian advector.
#include <algorithm>

#include "core/advection/stateless.h"

namespace whorl {
namespace {

/// q^{n+1}(x_i) = q^n(x_i^b): trace back, interpolate.  [Stam 1999; T alg 3.1]
/// Order 1 in time; in space the interpolation's order less one, for Δt in proportion to h. One trace and one
/// sample a node.
void advect(const Step& step, Groups groups, std::span<Workspace>) {
    step.apply(groups, 1, [&](const StepResult& r) {
        const Group& group = groups[r.group];
        for (int f = 0; f < group.count; ++f) {
            std::copy_n(r.q[f], r.nodes.count, group.to[f]->row(r.nodes.j) + r.nodes.i);
        }
    });
}

}  // namespace

extern constinit const Advector semi_lagrangian{
    .info{"semi-lagrangian", "Semi-Lagrangian", "Stam 1999; thesis alg. 3.1",
          "Trace each node back along the flow and interpolate there."},
    .traits{},
    .make = stateless<advect>};

}  // namespace whorl
