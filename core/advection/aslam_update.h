// The update that the affine semi-Lagrangian method and its relatives share.
#pragma once

#include "core/advection/stateless.h"

namespace whorl {

/// q^{n+1}(x_i) = Σ w_s (q_s + c_s · (x_i − x_s)) / Σ w_s, limited to the nodes that enclose x_i^b.
/// [T alg 4.1, 4.1–4.3]  One trace and one sample a particle.
void advect_aslam(const Step& step, Groups groups, std::span<Workspace> work);

}  // namespace whorl
