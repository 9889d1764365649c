// One Euler step back along the flow.
#include "core/tracing/make_tracer.h"

namespace whorl {
namespace {

/// x^b = x − Δt u(x).  [T 3.3]  Order 1 in time.
struct Euler {
    static constexpr SchemeInfo info{"euler", "Euler", "thesis eq. 3.3",
                                     "One straight step along the velocity at the point itself."};

    /// @param k1 the velocity at x
    /// @param x  the point to trace back, cells
    /// @param dt step, time; negative traces forward
    template <class T, class Velocity>
    static WHORL_INLINE Point<T> trace(const Velocity&, Point<T> k1, Point<T> x, Real dt) {
        return x - dt * k1;
    }
};

}  // namespace

extern constinit const Tracer euler = make_tracer<Euler>();

}  // namespace whorl
