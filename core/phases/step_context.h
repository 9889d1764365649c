// What a phase works on, and what phases keep from step to step.
#pragma once

#include <optional>

#include "core/advection/advection.h"
#include "core/experiments/experiment.h"
#include "core/forces/confinement.h"
#include "core/measure/measures.h"
#include "core/phases/last_advection.h"
#include "core/pressure/projection.h"
#include "core/scene/phase.h"

namespace whorl {

/// What the transports of both scheme sets remember.
struct AdvectionMemory {
    TransportMemory velocity, scalars;

    bool empty() const { return velocity.fields == 0 && scalars.fields == 0; }
    std::size_t bytes() const { return velocity.bytes.size() + scalars.bytes.size(); }
    bool operator==(const AdvectionMemory&) const = default;
};

/// What phases keep from step to step.
struct Solvers {
    Projection projection;
    Confinement confinement;
    Advection velocity, scalars;
    std::vector<AdvectedField> moving;  ///< scalars, u, v; kept for its memory
    /// Where an advection writes; after it, the fields as they were before.
    Fields next;
    /// Of the last advection; nothing where its fields or walls have changed since.
    std::optional<AdvectionSetup> advected;

    /// Brush, emitters or walls changed the fields in these cells: tells transports that remember.
    void edited(const CellRange& cells) {
        velocity.edited(cells);
        scalars.edited(cells);
    }
    /// Fields are others now: transports that remember begin anew.
    void forget() {
        velocity.forget();
        scalars.forget();
    }
    AdvectionMemory memory() const { return {velocity.memory(), scalars.memory()}; }
    void restore(const AdvectionMemory& memory) {
        velocity.restore(memory.velocity);
        scalars.restore(memory.scalars);
    }
};

/// All that a phase works on.
struct StepContext {
    const Scene& scene;
    const Experiment& experiment;
    State& state;
    Solvers& solvers;
    Measures& report;  ///< what a phase tells of its work
    Pool& pool;
    double dt;  ///< of the phase, time

    /// Whether the solver finds the flow.
    bool solved() const { return experiment.flow == nullptr; }
};

}  // namespace whorl
