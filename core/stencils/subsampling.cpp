// The subsampling stencil.
#include "core/stencils/stencil_shape.h"

namespace whorl {
namespace {

Offsets offsets(int zeta, int dimensions, std::uint64_t) {
    Offsets offsets;
    const auto part = [&](int a) { return (a + 0.5) / (zeta + 1) - 0.5; };
    for (int b = 0; b <= (dimensions == 1 ? 0 : zeta); ++b) {
        for (int a = 0; a <= zeta; ++a) offsets.push_back({part(a), dimensions == 1 ? 0.0 : part(b)});
    }
    return offsets;
}

}  // namespace

extern constinit const StencilShape subsampling{
    .info{"subsampling", "Subsampling", "thesis sec. 4.1", "The centres of (ζ+1)² equal parts of the cell."},
    .traits{},
    .offsets = offsets};

}  // namespace whorl
