// The steady Taylor-Green vortices of an ideal fluid: all change is the scheme's.  [Taylor and Green 1937]
#include <cmath>
#include <numbers>

#include "core/experiments/experiment.h"

namespace whorl {
namespace {

constexpr double speed = 4;  // length/time

constexpr double two_pi = 2 * std::numbers::pi;

/// The stream function ψ = sin(kx) sin(ky), −1 to 1.
double psi(WorldPoint at, const Grid& grid) {
    return std::sin(two_pi * at.x / grid.width()) * std::sin(two_pi * at.y / grid.height());
}

/// ψ scaled to 0 … 1: constant along the flow, so that smoke laid out as ψ does not change either.
void write_smoke(const Grid& grid, Field& q) {
    write_samples(q, grid, [&](WorldPoint at) { return 0.5 + 0.5 * psi(at, grid); });
}

/// u = ∂ψ/∂y, v = −∂ψ/∂x as differences of ψ at the corners, which are free of divergence to rounding.
void start(State& state) {
    const Grid& grid = state.grid();
    const double half = grid.h / 2;
    const double scale = speed * grid.height() / two_pi / grid.h;
    write_samples(state.velocity.u, grid, [&](WorldPoint at) {
        return scale * (psi({at.x, at.y + half}, grid) - psi({at.x, at.y - half}, grid));
    });
    write_samples(state.velocity.v, grid, [&](WorldPoint at) {
        return -scale * (psi({at.x + half, at.y}, grid) - psi({at.x - half, at.y}, grid));
    });
    write_smoke(grid, state.density());
}

}  // namespace

Experiment taylor_green() {
    return {.info = {"taylor-green", "Taylor-Green vortices", "Taylor and Green 1937",
                     "Four steady vortices of an ideal fluid: every loss of energy is the scheme's."},
            .setup =
                [](Scene& s) {
                    s.sides = sides::periodic;
                    s.steps = 600;
                },
            .start = start,
            .flow = nullptr,
            .exact =
                [](double, double, const Grid& grid, Field& q) {
                    write_smoke(grid, q);
                    return true;
                },
            .known = "always"};
}

}  // namespace whorl
