// The advection of velocity and scalars as a phase.
#include "core/phases/step_context.h"

namespace whorl {
namespace {

/// Fields that are advected by the same schemes go together, and share what they can. Where the flow is
/// given, only the density is advected.
void run(const StepContext& c) {
    State& state = c.state;
    Fields& next = c.solvers.next;
    const std::size_t scalars = c.solved() ? state.scalars.size() : 1;
    std::vector<AdvectedField>& moving = c.solvers.moving;
    moving.clear();
    for (std::size_t k = 0; k < scalars; ++k) moving.push_back({&state.scalars[k], &next.scalars[k]});
    if (c.solved()) {
        moving.push_back({&state.velocity.u, &next.velocity.u});
        moving.push_back({&state.velocity.v, &next.velocity.v});
    }
    const std::span<const AdvectedField> all = moving;
    const bool together = c.solved() && c.solvers.scalars.schemes() == c.solvers.velocity.schemes();
    const AdvectionStep step{&state.velocity, &state.boundary, &c.pool, c.dt};
    c.solvers.scalars.advect(together ? all : all.first(scalars), step);
    if (c.solved()) {
        if (together) {
            c.solvers.velocity.forget();
        } else {
            c.solvers.velocity.advect(all.last(2), step);
        }
        std::swap(state.velocity, next.velocity);
        state.boundary.enforce(state.velocity);
    }
    for (std::size_t k = 0; k < scalars; ++k) std::swap(state.scalars[k], next.scalars[k]);
    c.solvers.advected = {c.scene.velocity, c.scene.scalars, c.dt, c.scene.seed};
}

}  // namespace

extern const Phase advection_phase{.key = "advection",
                                   .title = "Advection",
                                   .run = run,
                                   .dissipates = true,
                                   .curves = PhaseCurves{.in_budget = 0, .in_times = 2}};

}  // namespace whorl
