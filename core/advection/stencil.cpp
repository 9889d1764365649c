#include "core/advection/stencil.h"

#include <cmath>

namespace whorl {
namespace {

Offsets offsets_of(Stencils::Id kind, int zeta, int dimensions, std::uint64_t seed) {
    if (zeta == 0) return {{0, 0}};
    return Stencils::dispatch(
        kind, [&]<class S>(std::type_identity<S>) { return S::offsets(zeta, dimensions, seed); });
}

}  // namespace

double Stencil::radius(int dimensions) {
    return std::sqrt(static_cast<double>(dimensions)) / 2;
}

Stencil::Stencil(Stencils::Id kind, int zeta, Weights::Id weights, int dimensions, std::uint64_t seed) {
    const Offsets offsets = offsets_of(kind, zeta, dimensions, seed);
    std::vector<double> w;
    for (const Offset& offset : offsets) {
        w.push_back(Weights::dispatch(weights, [&]<class W>(std::type_identity<W>) {
            return W::weight(std::hypot(offset.x, offset.y), radius(dimensions));
        }));
        weight_sum_ += w.back();
    }
    for (std::size_t k = 0; k < offsets.size(); ++k) {
        particles_.push_back({Vec2(offsets[k].x, offsets[k].y), static_cast<Real>(w[k] / weight_sum_)});
    }
}

}  // namespace whorl
