// Gaussian weights.
#include <cmath>

#include "core/stencils/weight_kernel.h"

namespace whorl {
namespace {

constexpr double sigma = 0.75;

double weight(double r, double radius) {
    return std::exp(-(r / radius) * (r / radius) / (2 * sigma * sigma));
}

}  // namespace

extern constinit const WeightKernel gaussian_weights{
    .info{"gaussian", "Gaussian", "thesis eq. 4.8–4.9", "A bell of deviation 0.75, between uniform and SPH."},
    .weight = weight};

}  // namespace whorl
