// Linear interpolation.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// q = q_i + t D.  [T 3.11]
/// Order 2 in space; never leaves the range of the enclosing samples.
struct Linear {
    static constexpr SchemeInfo info{
        "linear", "Linear", "Stam 1999; thesis eq. 3.11",
        "The straight line between neighbours. Never overshoots, smears the most."};
    static constexpr InterpolationTraits traits{
        .samples = 2, .bilinear = true, .overshoots = false, .weighted_sum = true, .order = 2};

    /// @param q0, q1 samples i and i + 1, any unit
    /// @param t      position in the interval, 0 to 1
    template <class T>
    static WHORL_INLINE T at(T q0, T q1, T t) {
        return lerp(q0, q1, t);
    }
};

}  // namespace

extern constinit const Interpolation linear = make_interpolation<Linear>();

}  // namespace whorl
