// The cubic Hermite interpolant that the slope-based schemes share.
#pragma once

#include "core/interpolation/interval.h"

namespace whorl {

/// The cubic through q_i with slopes d0 and d1 (per cell) at the interval's ends.  [T 3.12]
/// @param q0 sample i
/// @param D  q_{i+1} − q_i
/// @param t  position in the interval, 0 to 1
template <class T>
WHORL_INLINE T hermite(T q0, T D, T d0, T d1, T t) {
    const T a3 = d0 + d1 - 2 * D;
    const T a2 = 3 * D - 2 * d0 - d1;
    return q0 + t * (d0 + t * (a2 + t * a3));
}

/// The central slopes of samples i and i + 1, per cell.  [T 3.14]
template <class T>
struct Slopes {
    T D, left, right;
    WHORL_INLINE Slopes(T qm, T q0, T q1, T q2)
        : D(q1 - q0), left((q1 - qm) * Real(0.5)), right((q2 - q0) * Real(0.5)) {}
};

/// A slope that leads away from D is set to 0.  [T 3.15, A.1]
template <class T>
WHORL_INLINE T same_sign_or_zero(T slope, T D) {
    return select(slope * D > 0, slope, T{});
}

/// The same with the slopes of an interval.
template <class T>
WHORL_INLINE T hermite(T q0, const Slopes<T>& d, T t) {
    return hermite(q0, d.D, d.left, d.right, t);
}

/// A cubic in Hermite form; a scheme puts a `limited` of its own in this one's place.  [T 3.12]
template <class Scheme>
struct HermiteCubic {
    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       position in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(T qm, T q0, T q1, T q2, T t, IntervalFor<T>) {
        return hermite(q0, Scheme::limited(Slopes<T>(qm, q0, q1, q2)), t);
    }
    template <class T>
    static WHORL_INLINE Slopes<T> limited(Slopes<T> central) {
        return central;
    }
};

}  // namespace whorl
