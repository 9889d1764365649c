// The midpoint rule along the flow.
#include "core/tracing/make_tracer.h"

namespace whorl {
namespace {

/// x^m = x − ½Δt u(x), x^b = x − Δt u(x^m).  [T 3.4–3.5]  Order 2 in time.
struct Midpoint {
    static constexpr SchemeInfo info{"midpoint", "Midpoint", "thesis eq. 3.4–3.5",
                                     "Half a step to find the velocity, then a whole step with it."};

    /// @param u  velocity at a point, cells/time
    /// @param k1 the velocity at x
    /// @param x  the point to trace back, cells
    /// @param dt step, time; negative traces forward
    template <class T, class Velocity>
    static WHORL_INLINE Point<T> trace(const Velocity& u, Point<T> k1, Point<T> x, Real dt) {
        return x - dt * u(x - dt / 2 * k1);
    }
};

}  // namespace

extern constinit const Tracer midpoint = make_tracer<Midpoint>();

}  // namespace whorl
