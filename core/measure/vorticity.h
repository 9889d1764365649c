// Vorticity at cell centres.
#pragma once

#include "core/grid/boundary.h"
#include "core/parallel/pool.h"

namespace whorl {

/// ω = ∂v/∂x − ∂u/∂y by central differences of the velocity at centres, 1/time.  [F 28–30]
/// @param velocity ghosts filled
/// @param out      at centres; its ghosts are filled
void vorticity(const FaceVelocity& velocity, const Boundary& boundary, Field& out, Pool& pool);

}  // namespace whorl
