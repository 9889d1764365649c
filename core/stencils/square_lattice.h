// The square lattice that stencils are taken from.
#pragma once

#include "core/stencils/stencil_shape.h"

namespace whorl {

/// Points a/(2ζ), b/(2ζ) with a and b from −ζ to ζ, row by row, those for which `take(a, b)` holds.
template <class Take>
Offsets square_lattice(int zeta, int dimensions, const Take& take) {
    Offsets offsets;
    const int high = dimensions == 1 ? 0 : zeta;
    for (int b = -high; b <= high; ++b) {
        for (int a = -zeta; a <= zeta; ++a) {
            if (take(a, b)) offsets.push_back({a / (2.0 * zeta), b / (2.0 * zeta)});
        }
    }
    return offsets;
}

}  // namespace whorl
