// The Manhattan stencil.
#include <cstdlib>

#include "core/stencils/square_lattice.h"

namespace whorl {
namespace {

Offsets offsets(int zeta, int dimensions, std::uint64_t) {
    return square_lattice(zeta, dimensions, [&](int a, int b) { return std::abs(a) + std::abs(b) <= zeta; });
}

}  // namespace

extern constinit const StencilShape manhattan{
    .info{"manhattan", "Manhattan", "thesis sec. 4.1",
          "The chessboard's particles within ζ steps of the node: a diamond."},
    .traits{},
    .offsets = offsets};

}  // namespace whorl
