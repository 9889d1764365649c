// The chessboard stencil.
#include "core/stencils/square_lattice.h"

namespace whorl {
namespace {

Offsets offsets(int zeta, int dimensions, std::uint64_t) {
    return square_lattice(zeta, dimensions, [](int, int) { return true; });
}

}  // namespace

extern constinit const StencilShape chessboard{
    .info{"chessboard", "Chessboard", "thesis sec. 4.1",
          "A square lattice of (2ζ+1)² particles, out to the middle of the way."},
    .traits{},
    .offsets = offsets};

}  // namespace whorl
