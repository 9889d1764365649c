// Weights of smoothed particle hydrodynamics.
#include "core/stencils/weight_kernel.h"

namespace whorl {
namespace {

constexpr double kappa = 1.5;

double weight(double r, double radius) {
    const double a = kappa * radius * kappa * radius - r * r;
    return a * a * a;
}

}  // namespace

extern constinit const WeightKernel sph_weights{
    .info{"sph", "SPH", "Müller et al. 2003; thesis eq. 4.5",
          "The smoothing kernel of particle hydrodynamics: the node counts the most."},
    .weight = weight};

}  // namespace whorl
