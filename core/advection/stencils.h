// Where the particles of an ASLAM node start.  [T table 4.1, fig 4.2]
#pragma once

#include <cstdint>
#include <vector>

#include "core/schemes/scheme.h"

namespace whorl {

/// From the node, cells.
struct Offset {
    double x, y;
};
using Offsets = std::vector<Offset>;

// Each gives the offsets for ζ ≥ 1; in one dimension they lie on the x axis.

struct Chessboard {
    static constexpr SchemeInfo info{"chessboard", "Chessboard", "thesis sec. 4.1",
                                     "A square lattice of (2ζ+1)² particles, out to the middle of the way."};
    static constexpr bool seeded = false;
    static Offsets offsets(int zeta, int dimensions, std::uint64_t seed);
};
struct Manhattan {
    static constexpr SchemeInfo info{"manhattan", "Manhattan", "thesis sec. 4.1",
                                     "The chessboard's particles within ζ steps of the node: a diamond."};
    static constexpr bool seeded = false;
    static Offsets offsets(int zeta, int dimensions, std::uint64_t seed);
};
struct Subsampling {
    static constexpr SchemeInfo info{"subsampling", "Subsampling", "thesis sec. 4.1",
                                     "The centres of (ζ+1)² equal parts of the cell."};
    static constexpr bool seeded = false;
    static Offsets offsets(int zeta, int dimensions, std::uint64_t seed);
};
struct Jittered {
    static constexpr SchemeInfo info{"jittered", "Jittered", "after thesis ch. 6",
                                     "As many particles as the chessboard, spread as seeded blue noise."};
    static constexpr bool seeded = true;
    /// Mitchell's best candidate: each point is the one of many random ones that is farthest from those
    /// before it, across the cell's sides too, for neighbouring cells carry the same set.
    static Offsets offsets(int zeta, int dimensions, std::uint64_t seed);
};

}  // namespace whorl
