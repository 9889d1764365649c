// Fritsch and Carlson's monotone interpolation, with their circle and with the square.
#pragma once

#include "core/interpolation/hermite.h"
#include "core/interpolation/traits.h"

namespace whorl {

/// Catmull-Rom whose slope ratios α = δ_i/D, β = δ_{i+1}/D are brought into the monotone region: slopes of
/// the wrong sign to 0, then both scaled onto the circle α² + β² ≤ 9, interval by interval.  [T 3.15–3.23]
/// Order 3 in space where no slope is limited; stays in the range of its interval's samples.
struct FritschCarlson {
    static constexpr SchemeInfo info{"fritsch-carlson", "Fritsch-Carlson",
                                     "Fritsch and Carlson 1980; thesis eq. 3.20–3.23",
                                     "A cubic with slopes limited so that it never overshoots."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = false, .weighted_sum = false, .order = 3};

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       place in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(T qm, T q0, T q1, T q2, T t, IntervalFor<T>) {
        const Slopes<T> d = limited(Slopes<T>(qm, q0, q1, q2));
        return hermite(q0, d.D, d.left, d.right, t);
    }
    template <class T>
    static WHORL_INLINE Slopes<T> limited(Slopes<T> d) {
        const T left = same_sign_or_zero(d.left, d.D);
        const T right = same_sign_or_zero(d.right, d.D);
        const T size2 = left * left + right * right;
        const T limit2 = 9 * d.D * d.D;
        const T tau = select(size2 > limit2, square_root(limit2 / size2), every<T>(1));
        d.left = tau * left;
        d.right = tau * right;
        return d;
    }
};

/// As FritschCarlson, with each ratio limited to 3 by itself: the square [0, 3]² that [T A.3] argues for.
/// Order 3 in space where no slope is limited; stays in the range of its interval's samples.
struct FritschCarlsonSquare {
    static constexpr SchemeInfo info{
        "fritsch-carlson-square", "Fritsch-Carlson, square", "Fritsch and Carlson 1980; thesis sec. A.3",
        "Fritsch-Carlson with each slope limited by itself: the smallest change."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = false, .weighted_sum = false, .order = 3};

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       place in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(T qm, T q0, T q1, T q2, T t, IntervalFor<T>) {
        const Slopes<T> d = limited(Slopes<T>(qm, q0, q1, q2));
        return hermite(q0, d.D, d.left, d.right, t);
    }
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

}  // namespace whorl
