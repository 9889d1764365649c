#include "app/labs/weight_profile.h"

#include <cmath>

namespace whorl::app {

WeightProfile::WeightProfile(const Stencil& stencil, int dimensions, Id<WeightKernel> kind)
    : kind_(kind), radius_(Stencil::radius(dimensions)) {
    for (const Particle& particle : stencil.particles())
        sum_ +=
            raw(std::hypot(static_cast<double>(particle.offset.x), static_cast<double>(particle.offset.y)));
}

double WeightProfile::raw(double r) const {
    return kind_->weight(r, radius_);
}

}  // namespace whorl::app
