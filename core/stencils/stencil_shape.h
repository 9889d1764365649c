// Where the particles of an ASLAM node start: an entry of a list.  [T table 4.1, fig 4.2]
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/id.h"
#include "core/base/scheme_info.h"

namespace whorl {

/// From the node, cells.
struct Offset {
    double x, y;
};
using Offsets = std::vector<Offset>;

/// What a shape says of itself.
struct StencilTraits {
    bool seeded = false;  ///< whether the scene's seed gives another one
};

/// Neighbouring nodes share particles where those of any shape lie on a lattice with a few points a cell.
struct StencilShape {
    SchemeInfo info;
    StencilTraits traits;
    /// @param zeta ≥ 1: parametric size
    /// @param dimensions 1 puts all of them on the x axis
    Offsets (*offsets)(int zeta, int dimensions, std::uint64_t seed);

    /// All shapes; the first is the default.
    static Registry<StencilShape>& list();
};

}  // namespace whorl
