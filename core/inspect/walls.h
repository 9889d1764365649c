// Which nodes hold another node's value, or none, because of a wall.
#pragma once

#include <optional>
#include <utility>

#include "core/grid/boundary.h"

namespace whorl {

/// What walls make of the samples of a site, found by sending their numbers through the boundary's rules.
class WallRules {
  public:
    WallRules(const Boundary& boundary, Site site);

    /// The sample whose value (i, j) holds: itself, or in a solid the nearest that fluid touches.
    /// @return nothing on a face that holds 0
    std::optional<std::pair<int, int>> holds(int i, int j) const;
    /// Whether a sample holds what advection gave it.
    bool free(int i, int j) const { return holds(i, j) == std::pair(i, j); }

  private:
    Field numbers_;  ///< of samples, from 1
};

}  // namespace whorl
