#include "tests/extend/toys.h"

#include "core/interpolation/make_interpolation.h"
#include "core/limiters/make_limiter.h"
#include "core/stencils/stencil_shape.h"
#include "core/stencils/weight_kernel.h"
#include "core/tracing/make_tracer.h"
#include "tests/support/channel.h"

namespace whorl::test {
namespace {

/// Two samples, and not linear: flat at the samples.
struct Smoothstep {
    static constexpr SchemeInfo info{"smoothstep", "Smoothstep", "a test", "Flat at the samples."};
    static constexpr InterpolationTraits traits{
        .samples = 2, .overshoots = false, .weighted_sum = true, .order = 1};
    template <class T>
    static WHORL_INLINE T at(T q0, T q1, T t) {
        return q0 + t * t * (3 - 2 * t) * (q1 - q0);
    }
};

struct Heun {
    static constexpr SchemeInfo info{"heun", "Heun", "a test", "The mean of the velocities at both ends."};
    template <class T, class Velocity>
    static WHORL_INLINE Point<T> trace(const Velocity& u, Point<T> k1, Point<T> x, Real dt) {
        return x - dt / 2 * (k1 + u(x - dt * k1));
    }
};

struct Halfway {
    static constexpr SchemeInfo info{"halfway", "Halfway", "a test", "Half of the way to the first order."};
    static constexpr LimiterTraits traits{};
    template <class T>
    static WHORL_INLINE T limit(T value, T first_order, T low, T high) {
        return select(value < low, (value + first_order) / 2,
                      select(value > high, (value + first_order) / 2, value));
    }
};

/// More particles than any stencil of the program, and beyond the node's cell.
Offsets far_ring(int zeta, int dimensions, std::uint64_t) {
    Offsets offsets{{0, 0}};
    for (int k = 1; k <= 60 * zeta; ++k) {
        const double reach = 0.8 * k / (60 * zeta);
        offsets.push_back({k % 2 == 0 ? reach : -reach, dimensions == 1 ? 0 : (k % 3 - 1) * reach});
    }
    return offsets;
}

constexpr Interpolation smoothstep = make_interpolation<Smoothstep>();
constexpr Tracer heun = make_tracer<Heun>();
constexpr Limiter halfway = make_limiter<Halfway>();
constexpr StencilShape ring{
    .info{"far-ring", "Far ring", "a test", "Many particles, far out."}, .traits{}, .offsets = far_ring};
constexpr WeightKernel cone{.info{"cone", "Cone", "a test", "Falls in a line."},
                            .weight = [](double r, double radius) { return 2 * radius - r; }};
constexpr NamedSides channel{{"channel", "Channel", "a test", "Walls below and above."}, channel_x};

}  // namespace

void list_toys() {
    Interpolation::list().add(smoothstep);
    Tracer::list().add(heun);
    Limiter::list().add(halfway);
    StencilShape::list().add(ring);
    WeightKernel::list().add(cone);
    NamedSides::list().add(channel);
    Advector::list().add(running_mean);
    Advector::list().add(drifting_particles);
}

}  // namespace whorl::test
