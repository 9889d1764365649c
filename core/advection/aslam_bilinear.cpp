// ASLAM with the bilinear cross term.
#include "core/advection/aslam_update.h"

namespace whorl {

/// Value, gradient and bilinear cross term c_xy (x_i − x_s)(y_i − y_s), c_xy = (q₀₀ − q₁₀ − q₀₁ + q₁₁)/h².
/// [after T sec. 6.1]  The identity at rest.
extern constinit const Advector aslam_bilinear{
    .info{"aslam-bilinear", "ASLAM-bilinear", "after thesis sec. 6.1",
          "ASLAM with the bilinear cross term, which keeps a field at rest as it is."},
    .traits{
        .expansion = Expansion::CrossTerm, .limited = true, .clamp_source = "thesis ch. 4, after eq. 4.3"},
    .make = stateless<advect_aslam>};

}  // namespace whorl
