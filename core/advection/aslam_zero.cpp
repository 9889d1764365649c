// ASLAM without gradients.
#include "core/advection/aslam_update.h"

namespace whorl {

/// Value alone: supersampled semi-Lagrangian.  [T 5.8]  More dissipative than semi-Lagrangian itself.
extern constinit const Advector aslam_zero{
    .info{"aslam-0", "ASLAM-0", "thesis eq. 5.8",
          "ASLAM without the gradients: only more samples, and so more smearing."},
    .traits{.expansion = Expansion::Value, .limited = true, .clamp_source = "thesis ch. 4, after eq. 4.3"},
    .make = stateless<advect_aslam>};

}  // namespace whorl
