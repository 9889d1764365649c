// Which nodes hold another node's value, or 0, because of a wall.
#pragma once

#include <utility>

#include "core/grid/boundary.h"

namespace whorl {

/// What walls make of the samples of a site, found by sending their numbers through the boundary's rules.
class WallRules {
  public:
    WallRules(const Boundary& boundary, Site site);

    /// The sample whose value (i, j) holds: itself, or in a solid the nearest that fluid touches.
    std::pair<int, int> source(int i, int j) const;
    /// Whether (i, j) is a face that fluid may not cross, or holds the value of one.
    bool closed(int i, int j) const { return open_(i, j) == 0; }
    /// Whether a sample holds what advection gave it.
    bool free(int i, int j) const { return source(i, j) == std::pair(i, j) && !closed(i, j); }

  private:
    Field sources_;  ///< numbers of samples, row by row
    Field open_;     ///< 0 on what is closed, else 1
};

}  // namespace whorl
