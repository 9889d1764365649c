// The eigenvectors of the one-dimensional Laplacian between walls or around a ring.
#pragma once

#include <vector>

namespace whorl {

/// Orthonormal modes of −h² d²/dx² on n cells: cosines between two walls, cosines and sines around a ring
/// [Strang 1999]. Each is even or odd about the middle of the row, so that its first half is all there is to
/// know: `count` modes of `count` values, for an even mode includes the middle cell.
struct ModeSet {
    int count = 0;
    std::vector<double> values;       ///< value of cell i of mode k at [i * count + k]
    std::vector<double> eigenvalues;  ///< 0 … 4
};

struct Modes {
    ModeSet even, odd;
};

/// @param periodic around a ring, else between walls
Modes modes(int n, bool periodic);

}  // namespace whorl
