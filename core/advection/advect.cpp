#include "core/advection/advect.h"

namespace whorl {

void Mover::set(const SchemeSet& schemes, int dimensions, std::uint64_t seed) {
    if (stencil_ && schemes == schemes_ && dimensions == dimensions_ && seed == seed_) return;
    schemes_ = schemes;
    dimensions_ = dimensions;
    seed_ = seed;
    stencil_.emplace(schemes.stencil, schemes.zeta, schemes.weights, dimensions, seed);
}

void Mover::advect(const Group& group, const FaceVelocity& velocity, double dt, const Boundary& boundary,
                   Pool& pool) {
    const Site site = group.shape().site();
    const Step step{.kernels = choose_kernels(schemes_, boundary.periodic()),
                    .particles = stencil_->particles(),
                    .flow = {&velocity, site},
                    .boundary = &boundary,
                    .pool = &pool,
                    .dt = static_cast<Real>(dt / boundary.grid().h)};
    Workspace& work = work_[static_cast<int>(site)];
    Advectors::dispatch(schemes_.advector, [&]<class Advector>(std::type_identity<Advector>) {
        Advector::advect(step, group, work);
    });
    for (int f = 0; f < group.count; ++f) boundary.fill(*group.to[f]);
}

}  // namespace whorl
