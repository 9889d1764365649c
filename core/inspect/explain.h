// "What happened in this cell?": how the last step made one node's value.
#pragma once

#include "core/inspect/explanation.h"
#include "core/parallel/pool.h"

namespace whorl {

/// Why the steps of a set of schemes have no explanation; empty where they have one.
std::string unexplained(const SchemeSet& schemes);

/// Asks the solver's own kernels at one node. For predictor-correctors it takes their base steps of the whole
/// field once more, on the pool. The calling thread then treats denormal numbers as 0, as those that step do.
/// @param i, j of the quantity's field, from 0
/// @throws InputError if the quantity is not moved, has no such node, or its steps are unexplained
Explanation explain(const LastAdvection& last, FieldId quantity, int i, int j, Pool& pool);

}  // namespace whorl
