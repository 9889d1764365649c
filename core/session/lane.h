// One simulation of a session, with what stops it.
#pragma once

#include <optional>
#include <string>

#include "core/simulation/simulation.h"

namespace whorl {

/// A simulation that stops when a field loses its numbers, and can be started anew.
class Lane {
  public:
    Lane(Scene scene, Pool& pool) : simulation_(std::move(scene), pool) {}

    const Simulation& simulation() const { return simulation_; }
    /// Why the lane stopped: step, field and place; nothing while it runs.
    const std::optional<std::string>& failure() const { return failure_; }

    /// @throws InputError, with nothing changed
    void apply(const Command& command) {
        simulation_.apply(command);
        if (std::holds_alternative<Restart>(command)) failure_.reset();
    }
    /// One step, unless the lane has stopped. @return whether it holds a new, sound state
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

  private:
    Simulation simulation_;
    std::optional<std::string> failure_;
};

}  // namespace whorl
