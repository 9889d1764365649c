// Where limiters acted in a lane's last step, cell by cell, and how often.
#pragma once

#include "core/measure/measures.h"
#include "core/phases/last_advection.h"

namespace whorl {

/// What limiters, clamped interpolations among them, changed in one step.
struct LimiterMasks {
    Field density;   ///< at centres: 1 where they changed the cell's smoke, else 0
    Field velocity;  ///< at centres: the part of the cell's faces at which they changed the flow, 0 to 1
    LimiterCounts counts;
};

/// Costs as limiter_map for each quantity: ask for it only where it is looked at.
void mark_limits(const LastAdvection& last, Pool& pool, LimiterMasks& marks);

}  // namespace whorl
