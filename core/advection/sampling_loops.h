// Loops that read fields at places: interpolation, and the limits that the enclosing nodes set.
#pragma once

#include "core/advection/tracing_loops.h"
#include "core/interpolation/interval.h"

namespace whorl {

/// Four samples along x, `offset` from a place.
template <class T>
struct Four {
    T qm, q0, q1, q2;
    WHORL_INLINE Four(const Reader<T>& samples, Index offset) { samples.four(offset, qm, q0, q1, q2); }

    template <class Interpolation>
    WHORL_INLINE T at(T t, IntervalOf<T> interval) const {
        return Interpolation::at(qm, q0, q1, q2, t, interval);
    }
};

/// One axis first, then the other, over the 4 × 4 samples around a place.
template <class Interpolation, bool x_first, bool clamped, class T>
WHORL_INLINE T cubic(const Reader<T>& samples, Index stride, T x, T y, IntervalOf<T> in_x,
                     IntervalOf<T> in_y) {
    const Four<T> below(samples, -stride), low(samples, 0), high(samples, stride), above(samples, 2 * stride);
    T value;
    if constexpr (x_first) {
        value = Interpolation::at(below.template at<Interpolation>(x, in_x),
                                  low.template at<Interpolation>(x, in_x),
                                  high.template at<Interpolation>(x, in_x),
                                  above.template at<Interpolation>(x, in_x), y, in_y);
    } else {
        value = Interpolation::at(Interpolation::at(below.qm, low.qm, high.qm, above.qm, y, in_y),
                                  Interpolation::at(below.q0, low.q0, high.q0, above.q0, y, in_y),
                                  Interpolation::at(below.q1, low.q1, high.q1, above.q1, y, in_y),
                                  Interpolation::at(below.q2, low.q2, high.q2, above.q2, y, in_y), x, in_x);
    }
    if constexpr (clamped) {
        const T least = smaller(smaller(low.q0, low.q1), smaller(high.q0, high.q1));
        const T most = larger(larger(low.q0, low.q1), larger(high.q0, high.q1));
        value = smaller(larger(value, least), most);
    }
    return value;
}

template <class Interpolation, bool x_first, bool clamped, bool periodic>
struct SampleLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& field, const Places& at, int count, Values& out) {
        using T = RealLanes<bytes>;
        using I = IndexLanes<bytes>;
        const Real* origin = field.row(0);
        const Index stride = field.stride();
        const int last_x = field.width() - 1;
        const int last_y = field.height() - 1;
        for (int k = 0; k < count; k += lane_count<T>) {
            const T x = load<T>(at.x + k), y = load<T>(at.y + k);
            const Reader<T> samples(origin, load<I>(at.at + k));
            if constexpr (Interpolation::support == 2) {
                store(Cell<T>(samples, stride).bilinear(x, y), out + k);
            } else {
                store(cubic<Interpolation, x_first, clamped>(samples, stride, x, y,
                                                             {load<I>(at.i + k), last_x, periodic},
                                                             {load<I>(at.j + k), last_y, periodic}),
                      out + k);
            }
        }
    }
};

template <class Limiter>
struct LimitLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& q, const Index* at, int count, const Values& first_order,
                                 Values& value) {
        using T = RealLanes<bytes>;
        const Real* origin = q.row(0);
        const Index stride = q.stride();
        for (int k = 0; k < count; k += lane_count<T>) {
            const Cell<T> cell(Reader<T>(origin, load<IndexLanes<bytes>>(at + k)), stride);
            store(Limiter::limit(load<T>(value + k), load<T>(first_order + k), cell.lowest(), cell.highest()),
                  value + k);
        }
    }
};

}  // namespace whorl
