// Catmull-Rom interpolation.
#pragma once

#include "core/interpolation/hermite.h"
#include "core/interpolation/traits.h"

namespace whorl {

/// Cubic Hermite with central slopes.  [T 3.12–3.14, A.8]
/// Order 3 in space; overshoots.
struct CatmullRom {
    static constexpr SchemeInfo info{
        "catmull-rom", "Catmull-Rom", "Catmull and Rom 1974; thesis eq. A.8",
        "The cubic with central slopes. Sharp, but overshoots near steep edges."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = true, .weighted_sum = true, .order = 3};

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       place in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(T qm, T q0, T q1, T q2, T t, IntervalFor<T>) {
        const Slopes<T> d = limited(Slopes<T>(qm, q0, q1, q2));
        return hermite(q0, d.D, d.left, d.right, t);
    }
    template <class T>
    static WHORL_INLINE Slopes<T> limited(Slopes<T> d) {
        return d;
    }
};

}  // namespace whorl
