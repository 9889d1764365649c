// The jittered stencil: blue noise.
#include <cmath>
#include <random>

#include "core/stencils/stencil_shape.h"

namespace whorl {
namespace {

/// Mitchell's best candidate: each point is the one of many random ones that is farthest from those before
/// it, across the cell's sides too, for neighbouring cells carry the same set.
Offsets offsets(int zeta, int dimensions, std::uint64_t seed) {
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

}  // namespace

extern constinit const StencilShape jittered{
    .info{"jittered", "Jittered", "after thesis ch. 6",
          "As many particles as the chessboard, spread as seeded blue noise."},
    .traits{.seeded = true},
    .offsets = offsets};

}  // namespace whorl
