// The particles of a node: where they start and how much they count.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/real.h"
#include "core/stencils/stencil_shape.h"
#include "core/stencils/weight_kernel.h"

namespace whorl {

/// One fictitious particle x_s, in cells from its node x_i, and its normalised weight w_s.  [T sec. 4.1–4.2]
struct Particle {
    Vec2 offset{0, 0};
    Real weight = 1;
};

/// The particles of every node. Weights sum to 1.
class Stencil {
  public:
    /// @param dimensions 1 leaves out all particles off the x axis; radii are then Δ_r = ½ cell.
    /// @param zeta       0 gives the node alone: plain semi-Lagrangian
    /// @param seed       of shapes that are seeded
    /// @throws InputError if the weights have no sum to be normalised by
    Stencil(Id<StencilShape> shape, int zeta, Id<WeightKernel> weights, int dimensions, std::uint64_t seed);

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
