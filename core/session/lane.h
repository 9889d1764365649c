// One simulation of a session, with what stops it.
#pragma once

#include <optional>
#include <string>

#include "core/simulation/simulation.h"

namespace whorl {

/// All that a lane needs to go on.
struct LaneCheckpoint {
    Checkpoint simulation;
    std::optional<std::string> failure;
};

/// A simulation that stops when a field loses its numbers, and can be started anew.
class Lane {
  public:
    Lane(Scene scene, Pool& pool) : simulation_(std::move(scene), pool) {}

    Simulation& simulation() { return simulation_; }
    const Simulation& simulation() const { return simulation_; }
    /// Why the lane stopped: step, field and place; nothing while it runs.
    const std::optional<std::string>& failure() const { return failure_; }

    /// One step, unless the lane has stopped. @return whether it holds a new state, all of it finite
    bool step() {
        if (failure_) return false;
        try {
            simulation_.step();
            return true;
        } catch (const NotFinite& e) {
            failure_ = e.what();
            return false;
        }
    }
    /// Steps until the lane's time is as near to `time` as its Δt allows, never back.
    void step_to(double time) {
        const auto behind = [&] { return simulation_.state().time + 0.5 * simulation_.scene().dt < time; };
        while (behind() && step()) {
        }
    }
    void restart() {
        simulation_.restart();
        failure_.reset();
    }

    LaneCheckpoint checkpoint() const { return {simulation_.checkpoint(), failure_}; }
    void restore(const LaneCheckpoint& checkpoint) {
        simulation_.restore(checkpoint.simulation);
        failure_ = checkpoint.failure;
    }

  private:
    Simulation simulation_;
    std::optional<std::string> failure_;
};

}  // namespace whorl
