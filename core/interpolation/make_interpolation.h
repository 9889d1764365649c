// The loops of an interpolation, made from its formula along one axis.
#pragma once

#include <concepts>

#include "core/interpolation/interpolation.h"
#include "core/parallel/isa.h"
#include "core/sampling/axis.h"
#include "core/sampling/cell.h"

namespace whorl {

template <class I>
concept TwoSampleInterpolation = I::traits.samples == 2 && requires(Real q) {
    { I::at(q, q, q) } -> std::same_as<Real>;
};
template <class I>
concept FourSampleInterpolation = I::traits.samples == 4 && requires(Real q, Interval in) {
    { I::at(q, q, q, q, q, in) } -> std::same_as<Real>;
};
/// Its formula takes as many samples as its traits say.
template <class I>
concept InterpolationScheme = TwoSampleInterpolation<I> || FourSampleInterpolation<I>;

/// The 2 × 2 samples around points: one axis first, then the other.
template <TwoSampleInterpolation I, bool x_first, class T>
WHORL_INLINE T interpolate(const Cell<T>& q, T x, T y) {
    if constexpr (x_first) {
        return I::at(I::at(q.q00, q.q10, x), I::at(q.q01, q.q11, x), y);
    } else {
        return I::at(I::at(q.q00, q.q01, y), I::at(q.q10, q.q11, y), x);
    }
}

/// Four samples along x around points.
template <class T>
struct Four {
    T qm, q0, q1, q2;

    template <class I>
    WHORL_INLINE T at(T t, IntervalOf<T> interval) const {
        return I::at(qm, q0, q1, q2, t, interval);
    }
};

/// The 4 × 4 samples around points.
template <class T>
struct Patch {
    Four<T> below, low, high, above;

    WHORL_INLINE Patch(const Real* origin, Index stride, IndexVector<sizeof(T)> at) {
        if (is_contiguous(at)) {
            read(origin, stride, Contiguous<T>(at));
        } else {
            read(origin, stride, Gathered<T>(at));
        }
    }

    /// One axis first, then the other.
    template <class I, bool x_first>
    WHORL_INLINE T at(T x, T y, IntervalOf<T> in_x, IntervalOf<T> in_y) const {
        if constexpr (x_first) {
            return I::at(below.template at<I>(x, in_x), low.template at<I>(x, in_x),
                         high.template at<I>(x, in_x), above.template at<I>(x, in_x), y, in_y);
        } else {
            return I::at(I::at(below.qm, low.qm, high.qm, above.qm, y, in_y),
                         I::at(below.q0, low.q0, high.q0, above.q0, y, in_y),
                         I::at(below.q1, low.q1, high.q1, above.q1, y, in_y),
                         I::at(below.q2, low.q2, high.q2, above.q2, y, in_y), x, in_x);
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

template <class I, bool x_first, bool clamped, bool wraps_x, bool wraps_y>
struct SampleLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& field, const CellPositions& at, int count, Values& out) {
        using T = RealVector<bytes>;
        using Indices = IndexVector<bytes>;
        const Real* origin = field.row(0);
        const Index stride = field.stride();
        const int last_x = field.width() - 1;
        const int last_y = field.height() - 1;
        for (int k = 0; k < count; k += vector_width<T>) {
            const T x = load<T>(at.x + k), y = load<T>(at.y + k);
            const Indices samples = load<Indices>(at.at + k);
            if constexpr (TwoSampleInterpolation<I>) {
                const auto cell = Cell<T>::around(origin, stride, samples);
                const T value = interpolate<I, x_first>(cell, x, y);
                store(clamped ? cell.clamp(value) : value, out + k);
            } else {
                const Patch<T> patch(origin, stride, samples);
                const T value =
                    patch.template at<I, x_first>(x, y, {load<Indices>(at.i + k), last_x, wraps_x},
                                                  {load<Indices>(at.j + k), last_y, wraps_y});
                store(clamped ? patch.clamp(value) : value, out + k);
            }
        }
    }
};

template <class I>
SampleFn choose_sample_loop(const SampleOptions& o, Isa isa) {
    return with_bool(o.x_first || I::traits.bilinear, [&]<class X>(X) {
        return with_bool(o.clamped && !I::traits.bilinear, [&]<class C>(C) {
            return with_wraps(o.wraps, [&]<class WX, class WY>(WX, WY) {
                return PerIsa<SampleFn, SampleLoop<I, X::value, C::value, WX::value, WY::value>>::pick(isa);
            });
        });
    });
}

template <class I>
Real interpolate_at(const std::array<Real, 4>& q, Real t, const Interval& interval) {
    if constexpr (TwoSampleInterpolation<I>) {
        return I::at(q[1], q[2], t);
    } else {
        return I::at(q[0], q[1], q[2], q[3], t, interval);
    }
}

template <class I>
Slopes<Real> limited_slopes(const Slopes<Real>& central) {
    return I::limited(central);
}

/// The entry of a scheme
/// - `I::info` and `I::traits`;
/// - `I::at(q0, q1, t)`, or with four samples `I::at(qm, q0, q1, q2, t, interval)`: the value along one axis,
/// for
///   numbers and for registers of them;
/// - `I::limited(slopes)`, if it is a cubic in Hermite form.
template <InterpolationScheme I>
constexpr Interpolation make_interpolation() {
    constexpr bool cubic = requires(Slopes<Real> d) {
        I::limited(d);
    };
    Slopes<Real> (*limited)(const Slopes<Real>&) = nullptr;
    if constexpr (cubic) limited = limited_slopes<I>;
    return {I::info, I::traits, choose_sample_loop<I>, interpolate_at<I>, limited};
}

}  // namespace whorl
