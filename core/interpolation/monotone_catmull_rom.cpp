// Fedkiw's modified ("monotone") Catmull-Rom interpolation.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// Catmull-Rom whose slopes are set to 0 one by one where their sign differs from D's.  [T A.1, cases C1–C5]
/// Not followed: [F 101] also zeroes D, which makes the interpolant jump at the right sample.
/// Order 3 in space away from extrema; still overshoots where a slope exceeds 3 D.
struct MonotoneCatmullRom : HermiteCubic<MonotoneCatmullRom> {
    static constexpr SchemeInfo info{
        "monotone-catmull-rom", "Monotone Catmull-Rom", "Fedkiw, Stam and Jensen 2001; thesis sec. A.1",
        "Catmull-Rom with slopes of the wrong sign set to 0. Not quite monotone."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = true, .weighted_sum = false, .order = 3};

    template <class T>
    static WHORL_INLINE Slopes<T> limited(Slopes<T> d) {
        d.left = same_sign_or_zero(d.left, d.D);
        d.right = same_sign_or_zero(d.right, d.D);
        return d;
    }
};

}  // namespace

extern constinit const Interpolation monotone_catmull_rom = make_interpolation<MonotoneCatmullRom>();

}  // namespace whorl
