// Cubic B-spline approximation.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// Weights from the cubic B-spline's basis functions; near a box's walls those of boundary and external
/// samples. [T A.3 table]  Approximating: the curve does not pass through the samples, so each step smooths.
/// Order 2 in space; stays in the range of the four samples, not of the enclosing two.
struct BSpline {
    static constexpr SchemeInfo info{
        "b-spline", "Cubic B-spline", "Steffen et al. 2008; thesis table A.3",
        "Approximates instead of interpolating, so that even a step at rest blurs."};
    static constexpr InterpolationTraits traits{.samples = 4,
                                                .overshoots = true,
                                                .weighted_sum = true,
                                                .approximates = true,
                                                .order = 2,
                                                .min_samples = 4};

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       position in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(SameAs<T> qm, SameAs<T> q0, SameAs<T> q1, SameAs<T> q2, T t, IntervalFor<T> in) {
        const T internal = rising(t) * q2 + centre(t - 1) * q1 + centre(-t) * q0 + rising(1 - t) * qm;
        if (in.wraps) return internal;
        if (in.last == 0) return q1;
        const T first = near_wall<T>(qm, q0, q1, q2, t, in.i);
        const T last = near_wall<T>(q2, q1, q0, qm, 1 - t, in.last - 1 - in.i);
        T q = select(in.i >= in.last - 2, last, internal);
        q = select(in.i <= 1, first, q);
        q = select(in.i >= in.last, q0, q);
        return select(in.i < 0, q1, q);
    }

  private:
    /// The internal basis function on [−2, −1], x + 2 = t.
    template <class T>
    static WHORL_INLINE T rising(T t) {
        return t * t * t / 6;
    }
    /// The internal basis function on [−1, 0].
    template <class T>
    static WHORL_INLINE T centre(T x) {
        return (4 - 3 * x * x * (x + 2)) / 6;
    }

    /// Intervals 0 and 1 from a wall at the left: samples 0 (boundary) and 1 (external) have rows of their
    /// own.
    template <class T>
    static WHORL_INLINE T near_wall(T qm, T q0, T q1, T q2, T t, IndexOf<T> interval) {
        const T s = 1 - t;
        const T boundary_0 = Real(1.5) * t * t * (t / 2 - 1) + 1;
        const T external_0 = t * t * (7 - 11 * (t - 1)) / 12;
        const T in_0 = boundary_0 * q0 + external_0 * q1 + rising(t) * q2;
        const T boundary_1 = s * s * s / 4;
        const T external_1 = (7 * (t * t * t + 1) + 3 * t * (1 - 5 * t)) / 12;
        const T in_1 = boundary_1 * qm + external_1 * q0 + centre(t - 1) * q1 + rising(t) * q2;
        return select(interval == 0, in_0, in_1);
    }
};

}  // namespace

extern constinit const Interpolation b_spline = make_interpolation<BSpline>();

}  // namespace whorl
