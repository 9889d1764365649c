// Bridson's cubic interpolation.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// The cubic through four samples (Lagrange).  [T A.10]
/// Order 4 in space; overshoots.
struct Bridson {
    static constexpr SchemeInfo info{"bridson", "Bridson cubic", "Bridson 2008; thesis eq. A.10",
                                     "The cubic through the four nearest samples. Sharp, but overshoots."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = true, .weighted_sum = true, .order = 4};

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       position in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(T qm, T q0, T q1, T q2, T t, IntervalFor<T>) {
        const T t2 = t * t;
        const T t3 = t2 * t;
        const T wm = t2 / 2 - t / 3 - t3 / 6;
        const T w1 = t + (t2 - t3) / 2;
        const T w2 = (t3 - t) / 6;
        // w0 is 1 less the others; written as differences from q0, so that a constant stays itself.
        return q0 + wm * (qm - q0) + w1 * (q1 - q0) + w2 * (q2 - q0);
    }
};

}  // namespace

extern constinit const Interpolation bridson = make_interpolation<Bridson>();

}  // namespace whorl
