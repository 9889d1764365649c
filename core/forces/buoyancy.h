// Buoyancy: warm smoke rises, dense smoke sinks.
#pragma once

#include "core/parallel/pool.h"
#include "core/scene/state.h"

namespace whorl {

/// v += Δt f_y, f_y = −α ρ + β (T − T_amb) at centres, averaged onto y faces.  [F 4, 24]
/// @param state ghosts filled; on return those of the velocity are stale
/// @param dt    time
void add_buoyancy(State& state, double alpha, double beta, double ambient, double dt, Pool& pool);

}  // namespace whorl
