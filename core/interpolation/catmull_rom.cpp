// Catmull-Rom interpolation.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// Cubic Hermite with central slopes.  [T 3.12–3.14, A.8]
/// Order 3 in space; overshoots.
struct CatmullRom : HermiteCubic<CatmullRom> {
    static constexpr SchemeInfo info{
        "catmull-rom", "Catmull-Rom", "Catmull and Rom 1974; thesis eq. A.8",
        "The cubic with central slopes. Sharp, but overshoots near steep edges."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = true, .weighted_sum = true, .order = 3};
};

}  // namespace

extern constinit const Interpolation catmull_rom = make_interpolation<CatmullRom>();

}  // namespace whorl
