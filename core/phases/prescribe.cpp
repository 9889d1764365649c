// Writes the flow of an experiment that prescribes it.
#include "core/phases/step_context.h"

namespace whorl {
namespace {

void run(const StepContext& c) {
    c.experiment.flow(c.state.time, c.state.grid(), c.state.velocity);
    c.state.boundary.fill(c.state.velocity);
}

}  // namespace

extern const Phase prescribe_phase{"prescribe", "Prescribed flow", run};

}  // namespace whorl
