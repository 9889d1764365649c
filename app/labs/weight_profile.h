// Weights as a function of the distance from the node, scaled as a stencil's are.
#pragma once

#include "core/stencils/stencil.h"

namespace whorl::app {

/// One kind of weights over the particles of a stencil.
class WeightProfile {
  public:
    WeightProfile(const Stencil& stencil, int dimensions, Id<WeightKernel> kind);

    /// The weight that a particle at distance r (cells) has where the stencil's sum to 1.  [T fig 4.3]
    double operator()(double r) const { return raw(r) / sum_; }

  private:
    double raw(double r) const;

    Id<WeightKernel> kind_;
    double radius_;
    double sum_ = 0;
};

}  // namespace whorl::app
