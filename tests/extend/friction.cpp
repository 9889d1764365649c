// A phase that slows the flow, and an order of a step that has it.
#include <cmath>

#include "core/phases/step_context.h"
#include "tests/extend/additions.h"

namespace whorl::test {
namespace {

/// u ← u exp(−Δt / τ), τ = 1 time.
void run(const StepContext& c) {
    const auto keeps = static_cast<Real>(std::exp(-c.dt));
    for (Field* component : {&c.state.velocity.u, &c.state.velocity.v}) {
        for (int j = 0; j < component->height(); ++j) {
            for (int i = 0; i < component->width(); ++i) (*component)(i, j) *= keeps;
        }
    }
    c.state.boundary.enforce(c.state.velocity);
}

}  // namespace

const Phase friction{
    .key = "friction", .title = "Friction", .run = run, .curves = PhaseCurves{.in_budget = 3, .in_times = 4}};

const StepOrder rough{{"rough", "Rough", "a test", "As the thesis, and friction before the projection."},
                      {{"forces"}, {"friction"}, {"projection"}, {"advection"}}};

}  // namespace whorl::test
