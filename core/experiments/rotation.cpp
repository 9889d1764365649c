// The annulus stirred by a vortex in a box that turns back on itself.  [T sec. 5.1, 2d-ROTATION; T 5.1]
#include <cmath>
#include <numbers>

#include "core/experiments/annulus.h"
#include "core/experiments/experiment.h"

namespace whorl {
namespace {

constexpr double period = 10;  // time after which the annulus is back: 600 steps of the thesis
constexpr WorldPoint centre{20, 30};

/// u = 2 cos(πt/10) (sin²(πx̄) sin(πȳ) cos(πȳ), −sin(πx̄) cos(πx̄) sin²(πȳ)), x̄, ȳ in [0, 1].  [T 5.1]
void flow(double time, const Grid& grid, FaceVelocity& velocity) {
    constexpr double pi = std::numbers::pi;
    const double phase = 2 * std::cos(pi * time / period);
    write_samples(velocity.u, grid, [&](WorldPoint at) {
        const double x = pi * at.x / grid.width(), y = pi * at.y / grid.height();
        return phase * std::sin(x) * std::sin(x) * std::sin(y) * std::cos(y);
    });
    write_samples(velocity.v, grid, [&](WorldPoint at) {
        const double x = pi * at.x / grid.width(), y = pi * at.y / grid.height();
        return -phase * std::sin(x) * std::cos(x) * std::sin(y) * std::sin(y);
    });
}

/// Known only when the flow has turned back: to half a step.
bool exact(double time, double dt, const Grid& grid, Field& q) {
    if (std::abs(std::remainder(time, period)) > dt / 2) return false;
    write_annulus(grid, centre, q);
    return true;
}

}  // namespace

Experiment rotation() {
    return {.info = {"rotation", "Vortex in a box", "thesis sec. 5.1, eq. 5.1",
                     "A vortex stirs an annulus and turns back: exact at steps 600 and 1200."},
            .setup = thesis_test,
            .start = [](State& s) { write_annulus(s.grid(), centre, s.density()); },
            .flow = flow,
            .exact = exact,
            .known = "every 10 units of time: steps 600, 1200 … of Δt = 1/60"};
}

}  // namespace whorl
