// Fritsch and Carlson's monotone interpolation, with the square in the circle's place.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// As FritschCarlson, with each ratio limited to 3 by itself: the square [0, 3]² that [T A.3] argues for.
/// Order 3 in space where no slope is limited; stays in the range of its interval's samples.
struct FritschCarlsonSquare : HermiteCubic<FritschCarlsonSquare> {
    static constexpr SchemeInfo info{
        "fritsch-carlson-square", "Fritsch-Carlson, square", "Fritsch and Carlson 1980; thesis sec. A.3",
        "Fritsch-Carlson with each slope limited by itself: the smallest change."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = false, .weighted_sum = false, .order = 3};

    template <class T>
    static WHORL_INLINE Slopes<T> limited(Slopes<T> d) {
        d.left = limited(d.left, d.D);
        d.right = limited(d.right, d.D);
        return d;
    }

  private:
    template <class T>
    static WHORL_INLINE T limited(T slope, T D) {
        const T signed_slope = same_sign_or_zero(slope, D);
        return select(D > 0, smaller(signed_slope, 3 * D), larger(signed_slope, 3 * D));
    }
};

}  // namespace

extern constinit const Interpolation fritsch_carlson_square = make_interpolation<FritschCarlsonSquare>();

}  // namespace whorl
