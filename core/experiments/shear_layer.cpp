// Two shear layers that roll up into vortices.  [Bell, Colella and Glaz 1989]
#include <cmath>
#include <numbers>

#include "core/experiments/experiment.h"

namespace whorl {
namespace {

constexpr double speed = 6;       // length/time, so that the roll-up takes a few seconds
constexpr double thickness = 30;  // the paper's ρ: how steep the layers are
constexpr double kick = 0.05;     // the paper's δ: how much the layers are bent, as a share of the speed

/// Velocity of the layers at height y in [0, 1].
double layers(double y) {
    return y <= 0.5 ? std::tanh(thickness * (y - 0.25)) : std::tanh(thickness * (0.75 - y));
}

void start(State& state) {
    const Grid& grid = state.grid();
    write_samples(state.velocity.u, grid,
                  [&](WorldPoint at) { return speed * layers(at.y / grid.height()); });
    write_samples(state.velocity.v, grid, [&](WorldPoint at) {
        return speed * kick * std::sin(2 * std::numbers::pi * at.x / grid.width());
    });
    write_samples(state.density(), grid,
                  [&](WorldPoint at) { return 0.5 + 0.5 * layers(at.y / grid.height()); });
}

}  // namespace

Experiment shear_layer() {
    return {.info = {"shear-layer", "Shear layers", "Bell, Colella and Glaz 1989",
                     "Two layers of opposite flow roll up into vortices; dissipation decides how fine."},
            .setup =
                [](Scene& s) {
                    s.sides = sides::periodic;
                    s.steps = 720;
                },
            .start = start,
            .flow = nullptr,
            .exact = nullptr,
            .listed = false};
}

}  // namespace whorl
