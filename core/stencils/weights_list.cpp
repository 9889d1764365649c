// The list of weights, in the order of menus.
#include "core/stencils/weight_kernel.h"

namespace whorl {

extern const WeightKernel sph_weights, uniform_weights, gaussian_weights;

Registry<WeightKernel>& WeightKernel::list() {
    static Registry<WeightKernel> list("weights", {&sph_weights,      //
                                                   &uniform_weights,  //
                                                   &gaussian_weights});
    return list;
}

}  // namespace whorl
