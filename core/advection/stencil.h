// The particles of a node: where they start and how much they count.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/schemes/registry.h"

namespace whorl {

/// The particles of every node. Weights sum to 1.
class Stencil {
  public:
    /// @param dimensions 1 leaves out all particles off the x axis; radii are then Δ_r = ½ cell.
    /// @param zeta       0 gives the node alone: plain semi-Lagrangian
    /// @param seed       of `jittered`
    Stencil(Stencils::Id kind, int zeta, Weights::Id weights, int dimensions, std::uint64_t seed);

    /// Δ_r, the circumscribed circle's radius of a cell, in cells.  [T sec. 4.2]
    static double radius(int dimensions);

    std::span<const Particle> particles() const { return particles_; }

    /// Of the weights as their formula gives them, before they were normalised.  [T 4.1]
    double weight_sum() const { return weight_sum_; }

  private:
    std::vector<Particle> particles_;
    double weight_sum_ = 0;
};

}  // namespace whorl
