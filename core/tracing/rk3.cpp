// Ralston's third-order Runge-Kutta rule along the flow.
#include "core/tracing/make_tracer.h"

namespace whorl {
namespace {

/// k₁ = u(x), k₂ = u(x − ½Δt k₁), k₃ = u(x − ¾Δt k₂), x^b = x − Δt (2k₁ + 3k₂ + 4k₃)/9.  [Ralston 1962]
/// Order 3 in time.
struct Rk3 {
    static constexpr SchemeInfo info{"rk3", "Runge-Kutta 3", "Ralston 1962",
                                     "Three samples of the velocity, weighted for the least error."};

    /// @param u  velocity at a point, cells/time
    /// @param k1 the velocity at x
    /// @param x  the point to trace back, cells
    /// @param dt step, time; negative traces forward
    template <class T, class Velocity>
    static WHORL_INLINE Point<T> trace(const Velocity& u, Point<T> k1, Point<T> x, Real dt) {
        const Point<T> k2 = u(x - Real(0.5) * dt * k1);
        const Point<T> k3 = u(x - Real(0.75) * dt * k2);
        return x - dt / 9 * (Real(2) * k1 + Real(3) * k2 + Real(4) * k3);
    }
};

}  // namespace

extern constinit const Tracer rk3 = make_tracer<Rk3>();

}  // namespace whorl
