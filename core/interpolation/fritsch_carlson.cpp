// Fritsch and Carlson's monotone interpolation, with their circle.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// Catmull-Rom whose slope ratios α = δ_i/D, β = δ_{i+1}/D are brought into the monotone region: slopes of
/// the wrong sign to 0, then both scaled onto the circle α² + β² ≤ 9, interval by interval.  [T 3.15–3.23]
/// Order 3 in space where no slope is limited; stays in the range of its interval's samples.
struct FritschCarlson : HermiteCubic<FritschCarlson> {
    static constexpr SchemeInfo info{"fritsch-carlson", "Fritsch-Carlson",
                                     "Fritsch and Carlson 1980; thesis eq. 3.20–3.23",
                                     "A cubic with slopes limited so that it never overshoots."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = false, .weighted_sum = false, .order = 3};

    template <class T>
    static WHORL_INLINE Slopes<T> limited(Slopes<T> d) {
        const T left = same_sign_or_zero(d.left, d.D);
        const T right = same_sign_or_zero(d.right, d.D);
        const T size2 = left * left + right * right;
        const T limit2 = 9 * d.D * d.D;
        const T tau = select(size2 > limit2, square_root(limit2 / size2), broadcast<T>(1));
        d.left = tau * left;
        d.right = tau * right;
        return d;
    }
};

}  // namespace

extern constinit const Interpolation fritsch_carlson = make_interpolation<FritschCarlson>();

}  // namespace whorl
