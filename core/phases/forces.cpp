// Emitters, buoyancy and vorticity confinement.  [T alg 2.1; F 4, 11–13]
#include "core/forces/buoyancy.h"
#include "core/phases/step_context.h"
#include "core/sources/emitters.h"

namespace whorl {
namespace {

void run(const StepContext& c) {
    State& state = c.state;
    apply_emitters(state, c.scene.emitters, c.dt);
    for (const Emitter& emitter : c.scene.emitters) {
        if (is_open(emitter, state.time, c.dt)) c.solvers.edited(cells_of(emitter, state.grid()));
    }
    add_buoyancy(state, c.scene.alpha, c.scene.beta, c.scene.ambient, c.dt, c.pool);
    state.boundary.enforce(state.velocity);
    c.solvers.confinement.add(state, c.scene.confinement, c.dt, c.pool);
    state.boundary.enforce(state.velocity);
}

}  // namespace

extern const Phase forces_phase{
    .key = "forces", .title = "Forces", .run = run, .curves = PhaseCurves{.in_budget = 2, .in_times = 3}};

}  // namespace whorl
