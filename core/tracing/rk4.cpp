// The classical fourth-order Runge-Kutta rule along the flow.
#include "core/tracing/make_tracer.h"

namespace whorl {
namespace {

/// k₁ = u(x), k₂ = u(x − ½Δt k₁), k₃ = u(x − ½Δt k₂), k₄ = u(x − Δt k₃),
/// x^b = x − Δt (k₁ + 2k₂ + 2k₃ + k₄)/6.  [Kutta 1901]  Order 4 in time.
struct Rk4 {
    static constexpr SchemeInfo info{"rk4", "Runge-Kutta 4", "Kutta 1901",
                                     "Four samples of the velocity; the path is as good as exact."};

    /// @param u  velocity at a point, cells/time
    /// @param k1 the velocity at x
    /// @param x  the point to trace back, cells
    /// @param dt step, time; negative traces forward
    template <class T, class Velocity>
    static WHORL_INLINE Point<T> trace(const Velocity& u, Point<T> k1, Point<T> x, Real dt) {
        const Point<T> k2 = u(x - dt / 2 * k1);
        const Point<T> k3 = u(x - dt / 2 * k2);
        const Point<T> k4 = u(x - dt * k3);
        return x - dt / 6 * (k1 + Real(2) * k2 + Real(2) * k3 + k4);
    }
};

}  // namespace

extern constinit const Tracer rk4 = make_tracer<Rk4>();

}  // namespace whorl
