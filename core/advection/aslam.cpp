// The affine semi-Lagrangian advection method.
#include "core/advection/aslam_update.h"

namespace whorl {

/// Value and gradient of each particle.  [T 4.1–4.3]
/// About order 1 in h at fixed Δt [T table 5.2]. In 2D it is not the identity at rest: each step leaves
/// −Σ w_s c_xy s_x s_y.
extern constinit const Advector aslam{
    .info{"aslam", "ASLAM", "thesis alg. 4.1, eq. 4.1–4.3",
          "Trace a stencil of particles a node; each carries its value and gradient."},
    .traits{.expansion = Expansion::Gradient, .limited = true, .clamp_source = "thesis ch. 4, after eq. 4.3"},
    .make = stateless<advect_aslam>};

}  // namespace whorl
