// Where limiters acted in the last step.
#pragma once

#include "core/parallel/pool.h"
#include "core/phases/last_advection.h"

namespace whorl {

/// Marks the nodes whose value a limiter or a clamped interpolation changed on its way: 1 there, else 0.
/// Nodes that hold another's value, because of a wall, are not marked. Takes the steps in question again with
/// and without: some two to seven advections of the field.
/// @param marks gets the shape of the quantity's field
/// @return how many are marked; 0 and no mark where the quantity is not moved, or its steps are unexplained
int limiter_map(const LastAdvection& last, FieldId quantity, Pool& pool, Field& marks);

}  // namespace whorl
