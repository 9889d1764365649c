// The steady Taylor-Green vortices of an ideal fluid: all change is the scheme's.  [Taylor and Green 1937]
#include <cmath>
#include <numbers>

#include "core/experiments/experiment.h"

namespace whorl {
namespace {

constexpr double speed = 4;  // length/time

/// The stream function ψ = sin(kx) sin(ky), scaled to 0 … 1: constant along the flow, so that smoke laid out
/// as ψ does not change either.
double smoke(WorldPoint at, const Grid& grid) {
    constexpr double two_pi = 2 * std::numbers::pi;
    return 0.5 + 0.5 * std::sin(two_pi * at.x / grid.width()) * std::sin(two_pi * at.y / grid.height());
}

void write_smoke(const Grid& grid, Field& q) {
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) q(i, j) = static_cast<Real>(smoke(world(q, grid, i, j), grid));
    }
}

/// u = ∂ψ/∂y, v = −∂ψ/∂x as differences of ψ at the corners, which are free of divergence to rounding.
void start(State& state) {
    const Grid& grid = state.grid();
    constexpr double two_pi = 2 * std::numbers::pi;
    const double amplitude = speed * grid.height() / two_pi;
    const auto psi = [&](int i, int j) {
        return amplitude * std::sin(two_pi * i / grid.nx) * std::sin(two_pi * j / grid.ny);
    };
    FaceVelocity& velocity = state.velocity;
    for (int j = 0; j < velocity.u.height(); ++j) {
        for (int i = 0; i < velocity.u.width(); ++i) {
            velocity.u(i, j) = static_cast<Real>((psi(i, j + 1) - psi(i, j)) / grid.h);
        }
    }
    for (int j = 0; j < velocity.v.height(); ++j) {
        for (int i = 0; i < velocity.v.width(); ++i) {
            velocity.v(i, j) = static_cast<Real>(-(psi(i + 1, j) - psi(i, j)) / grid.h);
        }
    }
    write_smoke(grid, state.density);
}

}  // namespace

Experiment taylor_green() {
    return {.info = {"taylor-green", "Taylor-Green vortices", "Taylor and Green 1937",
                     "Four steady vortices of an ideal fluid: every loss of energy is the scheme's."},
            .setup =
                [](Scene& s) {
                    s.sides = Sides::of<Periodic>();
                    s.steps = 600;
                },
            .start = start,
            .flow = nullptr,
            .exact =
                [](double, double, const Grid& grid, Field& q) {
                    write_smoke(grid, q);
                    return true;
                }};
}

}  // namespace whorl
