// Bicubic interpolation.
#include "core/interpolation/make_interpolation.h"

namespace whorl {
namespace {

/// The bicubic patch that matches q, q_x, q_y and q_xy at the four enclosing samples, the derivatives by
/// central differences.  [T A.17–A.21]  With those it is the tensor product of Catmull-Rom, and is computed
/// as that; a test solves A.19 and compares. Order 3 in space; overshoots.
struct Bicubic {
    static constexpr SchemeInfo info{
        "bicubic", "Bicubic", "thesis eq. A.17–A.21",
        "One patch a cell from values and derivatives; equals Catmull-Rom in x and y."};
    static constexpr InterpolationTraits traits{
        .samples = 4, .overshoots = true, .weighted_sum = true, .order = 3};

    /// @param qm … q2 samples i − 1 … i + 2, any unit
    /// @param t       position in [i, i + 1], 0 to 1
    template <class T>
    static WHORL_INLINE T at(T qm, T q0, T q1, T q2, T t, IntervalFor<T>) {
        return hermite(q0, Slopes<T>(qm, q0, q1, q2), t);
    }
};

}  // namespace

extern constinit const Interpolation bicubic = make_interpolation<Bicubic>();

}  // namespace whorl
