#include "core/advection/advect.h"

namespace whorl {

void Mover::set(const SchemeSet& schemes, int dimensions, std::uint64_t seed) {
    if (stencil_ && schemes == schemes_ && dimensions == dimensions_ && seed == seed_) return;
    schemes_ = schemes;
    dimensions_ = dimensions;
    seed_ = seed;
    stencil_.emplace(schemes.stencil, schemes.zeta, schemes.weights, dimensions, seed);
    static_assert(Lattice::max_per_cell >= 2 * SchemeSet::max_zeta);
    lattice_ = schemes.affine() ? Lattice::of(stencil_->particles()) : std::nullopt;
}

void Mover::advect(Groups groups, const FaceVelocity& velocity, double dt, const Boundary& boundary,
                   Pool& pool) {
    if (lattice_) {
        int fields = 0;
        for (const Group& group : groups) fields += group.count;
        tiles_.resize(static_cast<std::size_t>(pool.threads()));
        for (LatticeTile& tile : tiles_) tile.shape(*lattice_, fields);
    }
    const Step step{.kernels = choose_kernels(schemes_, boundary.periodic()),
                    .particles = stencil_->particles(),
                    .lattice = lattice_ ? &*lattice_ : nullptr,
                    .tiles = tiles_,
                    .velocity = &velocity,
                    .boundary = &boundary,
                    .pool = &pool,
                    .dt = static_cast<Real>(dt / boundary.grid().h)};
    Advectors::dispatch(schemes_.advector, [&]<class Advector>(std::type_identity<Advector>) {
        Advector::advect(step, groups, work_);
    });
    for (const Group& group : groups) {
        for (int f = 0; f < group.count; ++f) boundary.fill(*group.to[f]);
    }
}

}  // namespace whorl
