#include "core/advection/stencils.h"

#include <cmath>
#include <cstdlib>
#include <random>

namespace whorl {
namespace {

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

}  // namespace

Offsets Chessboard::offsets(int zeta, int dimensions, std::uint64_t) {
    return lattice(zeta, dimensions, false);
}

Offsets Manhattan::offsets(int zeta, int dimensions, std::uint64_t) {
    return lattice(zeta, dimensions, true);
}

Offsets Subsampling::offsets(int zeta, int dimensions, std::uint64_t) {
    Offsets offsets;
    const auto part = [&](int a) { return (a + 0.5) / (zeta + 1) - 0.5; };
    for (int b = 0; b <= (dimensions == 1 ? 0 : zeta); ++b) {
        for (int a = 0; a <= zeta; ++a) offsets.push_back({part(a), dimensions == 1 ? 0.0 : part(b)});
    }
    return offsets;
}

Offsets Jittered::offsets(int zeta, int dimensions, std::uint64_t seed) {
    const std::size_t side = 2 * static_cast<std::size_t>(zeta) + 1;
    const std::size_t count = dimensions == 1 ? side : side * side;
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

}  // namespace whorl
