#include "core/stencils/stencil.h"

#include <cmath>

#include "core/base/error.h"

namespace whorl {

double Stencil::radius(int dimensions) {
    return std::sqrt(static_cast<double>(dimensions)) / 2;
}

Stencil::Stencil(Id<StencilShape> shape, int zeta, Id<WeightKernel> weights, int dimensions,
                 std::uint64_t seed) {
    const Offsets offsets = zeta == 0 ? Offsets{{0, 0}} : shape->offsets(zeta, dimensions, seed);
    std::vector<double> w;
    for (const Offset& offset : offsets) {
        w.push_back(weights->weight(std::hypot(offset.x, offset.y), radius(dimensions)));
        weight_sum_ += w.back();
    }
    if (!std::isfinite(weight_sum_) || weight_sum_ == 0) {
        throw InputError(std::string(weights.key()) + " weights of the " + std::string(shape.key()) +
                         " stencil have no sum");
    }
    for (std::size_t k = 0; k < offsets.size(); ++k) {
        particles_.push_back({Vec2(offsets[k].x, offsets[k].y), static_cast<Real>(w[k] / weight_sum_)});
    }
}

}  // namespace whorl
