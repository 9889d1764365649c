// Vorticity confinement: a force that feeds vortices back what dissipation takes.
#pragma once

#include "core/parallel/pool.h"
#include "core/scene/state.h"

namespace whorl {

/// Adds f = ε h (N_y ω, −N_x ω) to the velocity, with η = ∇|ω|, N = η/(|η| + tiny) at centres and forces
/// averaged onto faces.  [F 11–13, 23–34]
class Confinement {
  public:
    /// @param state ghosts filled; on return those of the velocity are stale
    /// @param dt    time
    void add(State& state, double epsilon, double dt, Pool& pool);

  private:
    Field vorticity_, force_x_, force_y_;
};

}  // namespace whorl
