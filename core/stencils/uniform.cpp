// Uniform weights.
#include "core/stencils/weight_kernel.h"

namespace whorl {

extern constinit const WeightKernel uniform_weights{
    .info{"uniform", "Uniform", "thesis eq. 4.4", "Every particle counts the same."},
    .weight = [](double, double) { return 1.0; }};

}  // namespace whorl
