// Where the particles of an ASLAM node start.  [T table 4.1, fig 4.2]
#pragma once

#include "core/schemes/scheme.h"

namespace whorl {

struct Chessboard {
    static constexpr SchemeInfo info{"chessboard", "Chessboard", "thesis sec. 4.1",
                                     "A square lattice of (2ζ+1)² particles, out to the middle of the way."};
};
struct Manhattan {
    static constexpr SchemeInfo info{"manhattan", "Manhattan", "thesis sec. 4.1",
                                     "The chessboard's particles within ζ steps of the node: a diamond."};
};
struct Subsampling {
    static constexpr SchemeInfo info{"subsampling", "Subsampling", "thesis sec. 4.1",
                                     "The centres of (ζ+1)² equal parts of the cell."};
};
struct Jittered {
    static constexpr SchemeInfo info{"jittered", "Jittered", "after thesis ch. 6",
                                     "As many particles as the chessboard, spread as seeded blue noise."};
};

}  // namespace whorl
