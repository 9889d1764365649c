// The cell of four samples around a point, and its bilinear value.
#pragma once

#include "core/parallel/gather.h"

namespace whorl {

/// q = q₀ + t (q₁ − q₀).  [T 3.11]
/// @param t place between the two, 0 to 1
template <class T>
WHORL_INLINE T lerp(T q0, T q1, T t) {
    return q0 + t * (q1 - q0);
}

/// The four samples around points.
template <class T>
struct Cell {
    T q00, q10, q01, q11;

    template <class Samples>
    WHORL_INLINE Cell(const Real* origin, Index stride, const Samples& at) {
        at.pair(origin, q00, q10);
        at.pair(origin + stride, q01, q11);
    }
    static WHORL_INLINE Cell around(const Real* origin, Index stride, IndexVector<sizeof(T)> at) {
        return is_contiguous(at) ? Cell(origin, stride, Contiguous<T>(at))
                                 : Cell(origin, stride, Gathered<T>(at));
    }
    /// Of contiguous points, the first of them at `from`.
    WHORL_INLINE Cell(const Real* from, Index stride)
        : q00(load<T>(from)),
          q10(load<T>(from + 1)),
          q01(load<T>(from + stride)),
          q11(load<T>(from + stride + 1)) {}

    WHORL_INLINE T bilinear(T x, T y) const { return lerp(lerp(q00, q10, x), lerp(q01, q11, x), y); }
    WHORL_INLINE T lowest() const { return smaller(smaller(q00, q10), smaller(q01, q11)); }
    WHORL_INLINE T highest() const { return larger(larger(q00, q10), larger(q01, q11)); }
    WHORL_INLINE T clamp(T value) const { return smaller(larger(value, lowest()), highest()); }
};

}  // namespace whorl
