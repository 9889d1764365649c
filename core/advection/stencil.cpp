#include "core/advection/stencil.h"

#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace whorl {
namespace {

struct Offset {
    double x, y;
};
using Offsets = std::vector<Offset>;

Offsets lattice(int zeta, int dimensions, bool diamond) {
    Offsets offsets;
    const int high = dimensions == 1 ? 0 : zeta;
    for (int b = -high; b <= high; ++b) {
        for (int a = -zeta; a <= zeta; ++a) {
            if (diamond && std::abs(a) + std::abs(b) > zeta) continue;
            offsets.push_back({a / (2.0 * zeta), b / (2.0 * zeta)});
        }
    }
    return offsets;
}

Offsets subsamples(int zeta, int dimensions) {
    Offsets offsets;
    const auto part = [&](int a) { return (a + 0.5) / (zeta + 1) - 0.5; };
    for (int b = 0; b <= (dimensions == 1 ? 0 : zeta); ++b) {
        for (int a = 0; a <= zeta; ++a) offsets.push_back({part(a), dimensions == 1 ? 0.0 : part(b)});
    }
    return offsets;
}

/// Mitchell's best candidate: each point is the one of many random ones that is farthest from those before
/// it, across the cell's sides too, for neighbouring cells carry the same set.
Offsets blue_noise(std::size_t count, int dimensions, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
    const auto wrapped = [](double d) { return d - std::round(d); };
    constexpr std::size_t candidates_per_point = 16;
    Offsets offsets{{0, 0}};
    while (offsets.size() < count) {
        Offset best{};
        double best_distance = -1;
        for (std::size_t k = 0; k < candidates_per_point * offsets.size(); ++k) {
            const Offset candidate{uniform(), dimensions == 1 ? 0.0 : uniform()};
            double nearest = 1e9;
            for (const Offset& other : offsets) {
                nearest = std::min(
                    nearest, std::hypot(wrapped(candidate.x - other.x), wrapped(candidate.y - other.y)));
            }
            if (nearest > best_distance) {
                best_distance = nearest;
                best = candidate;
            }
        }
        offsets.push_back(best);
    }
    return offsets;
}

Offsets offsets_of(Stencils::Id kind, int zeta, int dimensions, std::uint64_t seed) {
    if (zeta == 0) return {{0, 0}};
    if (kind == Stencils::of<Manhattan>()) return lattice(zeta, dimensions, true);
    if (kind == Stencils::of<Subsampling>()) return subsamples(zeta, dimensions);
    if (kind == Stencils::of<Jittered>()) {
        const std::size_t side = 2 * static_cast<std::size_t>(zeta) + 1;
        return blue_noise(dimensions == 1 ? side : side * side, dimensions, seed);
    }
    return lattice(zeta, dimensions, false);
}

}  // namespace

double Stencil::radius(int dimensions) {
    return std::sqrt(static_cast<double>(dimensions)) / 2;
}

Stencil::Stencil(Stencils::Id kind, int zeta, Weights::Id weights, int dimensions, std::uint64_t seed) {
    const Offsets offsets = offsets_of(kind, zeta, dimensions, seed);
    std::vector<double> w;
    double sum = 0;
    for (const Offset& offset : offsets) {
        w.push_back(Weights::dispatch(weights, [&]<class W>(std::type_identity<W>) {
            return W::weight(std::hypot(offset.x, offset.y), radius(dimensions));
        }));
        sum += w.back();
    }
    weight_sum_ = sum;
    count_ = static_cast<int>(offsets.size());
    for (int k = 0; k < count_; ++k) {
        particles_[k] = {Vec2(offsets[k].x, offsets[k].y), static_cast<Real>(w[k] / sum)};
    }
}

}  // namespace whorl
