// Fedkiw's modified ("monotone") Catmull-Rom interpolation.
#pragma once

#include "core/interpolation/hermite.h"
#include "core/interpolation/traits.h"

namespace whorl {

/// Catmull-Rom whose slopes are set to 0 one by one where their sign differs from D's.  [T A.1, cases C1–C5]
/// Not followed: [F 101] also zeroes D, which makes the interpolant jump at the right sample.
/// Order 3 in space away from extrema; still overshoots where a slope exceeds 3 D.
struct MonotoneCatmullRom {
    static constexpr SchemeInfo info{
        "monotone-catmull-rom", "Monotone Catmull-Rom", "Fedkiw, Stam and Jensen 2001; thesis sec. A.1",
        "Catmull-Rom with slopes of the wrong sign set to 0. Not quite monotone."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = true, .weighted_sum = false, .order = 3};

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       place in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(T qm, T q0, T q1, T q2, T t, IntervalFor<T>) {
        const Slopes<T> d = limited(Slopes<T>(qm, q0, q1, q2));
        return hermite(q0, d.D, d.left, d.right, t);
    }
    template <class T>
    static WHORL_INLINE Slopes<T> limited(Slopes<T> d) {
        d.left = same_sign_or_zero(d.left, d.D);
        d.right = same_sign_or_zero(d.right, d.D);
        return d;
    }
};

}  // namespace whorl
