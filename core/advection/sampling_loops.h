// Loops that read fields at places: interpolation, and the limits that the enclosing nodes set.
#pragma once

#include "core/advection/tracing_loops.h"
#include "core/interpolation/traits.h"

namespace whorl {

/// Four samples along x around places.
template <class T>
struct Four {
    T qm, q0, q1, q2;

    template <class Interpolation>
    WHORL_INLINE T at(T t, IntervalOf<T> interval) const {
        return Interpolation::at(qm, q0, q1, q2, t, interval);
    }
};

/// The 4 × 4 samples around places.
template <class T>
struct Patch {
    Four<T> below, low, high, above;

    WHORL_INLINE Patch(const Real* origin, Index stride, IndexLanes<sizeof(T)> at) {
        if (in_a_row(at)) {
            read(origin, stride, InARow<T>(at));
        } else {
            read(origin, stride, Apart<T>(at));
        }
    }

    /// One axis first, then the other.
    template <class Interpolation, bool x_first>
    WHORL_INLINE T at(T x, T y, IntervalOf<T> in_x, IntervalOf<T> in_y) const {
        if constexpr (x_first) {
            return Interpolation::at(
                below.template at<Interpolation>(x, in_x), low.template at<Interpolation>(x, in_x),
                high.template at<Interpolation>(x, in_x), above.template at<Interpolation>(x, in_x), y, in_y);
        } else {
            return Interpolation::at(Interpolation::at(below.qm, low.qm, high.qm, above.qm, y, in_y),
                                     Interpolation::at(below.q0, low.q0, high.q0, above.q0, y, in_y),
                                     Interpolation::at(below.q1, low.q1, high.q1, above.q1, y, in_y),
                                     Interpolation::at(below.q2, low.q2, high.q2, above.q2, y, in_y), x,
                                     in_x);
        }
    }
    WHORL_INLINE T clamp(T value) const {
        const T least = smaller(smaller(low.q0, low.q1), smaller(high.q0, high.q1));
        const T most = larger(larger(low.q0, low.q1), larger(high.q0, high.q1));
        return smaller(larger(value, least), most);
    }

  private:
    template <class Samples>
    WHORL_INLINE void read(const Real* origin, Index stride, const Samples& at) {
        at.four(origin - stride, below.qm, below.q0, below.q1, below.q2);
        at.four(origin, low.qm, low.q0, low.q1, low.q2);
        at.four(origin + stride, high.qm, high.q0, high.q1, high.q2);
        at.four(origin + 2 * stride, above.qm, above.q0, above.q1, above.q2);
    }
};

template <InterpolationScheme Interpolation, bool x_first, bool clamped, bool periodic>
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
            const I samples = load<I>(at.at + k);
            constexpr InterpolationTraits traits = Interpolation::traits;
            if constexpr (TwoSampleInterpolation<Interpolation>) {
                const auto cell = Cell<T>::around(origin, stride, samples);
                const T value = cell.template at < Interpolation, x_first || traits.bilinear > (x, y);
                store(clamped && !traits.bilinear ? cell.clamp(value) : value, out + k);
            } else {
                const Patch<T> patch(origin, stride, samples);
                const T value = patch.template at<Interpolation, x_first>(
                    x, y, {load<I>(at.i + k), last_x, periodic}, {load<I>(at.j + k), last_y, periodic});
                store(clamped ? patch.clamp(value) : value, out + k);
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
            const auto cell = Cell<T>::around(origin, stride, load<IndexLanes<bytes>>(at + k));
            store(Limiter::limit(load<T>(value + k), load<T>(first_order + k), cell.lowest(), cell.highest()),
                  value + k);
        }
    }
};

}  // namespace whorl
