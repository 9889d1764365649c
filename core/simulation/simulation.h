// A running scene: the order of a step, and nothing else.
#pragma once

#include <optional>

#include "core/phases/step_context.h"
#include "core/scene/step_order.h"
#include "core/sources/edit.h"

namespace whorl {

/// All that a simulation needs to go on with the same bits.
struct Checkpoint {
    Scene scene;
    State state;
    Measures measures;
    FlowSums resampled;
    Projection::Memory projection;
    AdvectionMemory advection;
};

class Simulation {
  public:
    /// @param pool does the work; must outlive the simulation
    /// @throws InputError if the scene's choices do not go together
    Simulation(Scene scene, Pool& pool);

    /// One step of Δt.  [T alg 2.1 or F 14]
    /// @throws NotFinite if a field has lost its numbers; the state is then of no use
    void step();

    // These act before the next step.
    void apply(const Edit& edit);
    /// Another setup for the running fields, which are resampled if the grid changes. What a scene starts
    /// with (emitters aside) is for a restart.  @throws InputError, with nothing changed
    void set(const Scene& scene);
    /// Back to the start of the scene as it is now set, as if made anew.
    void restart();

    Checkpoint checkpoint() const {
        return {scene_,           state_, measures_, resampled_, solvers_.projection.memory(state_.boundary),
                solvers_.memory()};
    }
    void restore(const Checkpoint& checkpoint);
    /// Made from every bit that transports remember beside the state; 0 where they remember nothing.
    std::uint64_t memory_digest() const;

    const Scene& scene() const { return scene_; }
    const State& state() const { return state_; }
    /// Of the last finished step, or of the start.
    const Measures& measures() const { return measures_; }
    /// Writes the exact density at the present time. @return false where it is not known
    bool exact(Field& density) const;
    /// What the last step's advection began with; nothing before the first step, or where the fields or walls
    /// have changed since. Holds until the next step or change.
    std::optional<LastAdvection> last_advection() const;

  private:
    void set_scene(const Scene& scene);
    const StepOrder& order() const;
    /// Runs the phases of an order. @return the flow's sums at its end
    FlowSums run(const StepOrder& order);
    /// @param flow of the present velocity
    void measure(const FlowSums& flow);

    Scene scene_;
    Pool* pool_;
    const Experiment* experiment_;
    State state_;
    Measures measures_;

    Solvers solvers_;
    Field exact_;
    StateReducer reducer_;
    FlowSums resampled_;  ///< what changes of grid did to the flow since the last step
};

/// A field holds a value that is not finite.
struct NotFinite : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace whorl
