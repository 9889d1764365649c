// Other lanes: what becomes of an arrangement when one is added, taken away or moved.
#pragma once

#include "core/session/command.h"

namespace whorl::app {

/// Puts a lane behind the one at `place`, whose fields it goes on with. @param as_reference  it is the
/// reference then
void add_lane(Arrange& lanes, std::size_t place, LaneSetup lane, bool as_reference);

void remove_lane(Arrange& lanes, std::size_t place);

/// Swaps a lane with the next one (1) or the one before (−1).
void move_lane(Arrange& lanes, std::size_t place, int by);

/// A lane like another one, with a name of its own.
LaneSetup copy_of(const LaneSetup& lane, const std::vector<LaneSetup>& lanes);

}  // namespace whorl::app
