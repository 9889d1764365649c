// The projection as a phase, with what it reports.
#include "core/phases/step_context.h"

namespace whorl {
namespace {

void run(const StepContext& c) {
    const ProjectionReport report =
        c.solvers.projection.project(c.state.velocity, c.dt, c.state.boundary, c.state.pressure, c.pool);
    Measures& m = c.report;
    m.divergence_before = report.divergence_before;
    m.divergence_after = report.divergence_after;
    m.relative_divergence =
        report.largest_speed > 0 ? report.divergence_after * c.state.grid().h / report.largest_speed : 0;
    m.pressure = report.solve;
    m.pressure.solver = report.solver;
    m.pressure_unsupported_reason = report.unsupported_reason;
    m.removed_mean = report.removed_mean;
}

}  // namespace

extern const Phase projection_phase{.key = "projection",
                                    .title = "Projection",
                                    .run = run,
                                    .curves = PhaseCurves{.in_budget = 1, .in_times = 1}};

}  // namespace whorl
