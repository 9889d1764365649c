#include "core/advection/advect.h"

#include <algorithm>

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

void Mover::advect(std::span<const AdvectedField> fields, const FaceVelocity& velocity, double dt,
                   const Boundary& boundary, Pool& pool) {
    if (lattice_) {
        tiles_.resize(static_cast<std::size_t>(pool.threads()));
        const auto most = static_cast<int>(max_groups) * Group::max_fields;
        for (LatticeTile& tile : tiles_)
            tile.shape(*lattice_, std::min(static_cast<int>(fields.size()), most));
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
        for (int k = 0; true; ++k) {
            const Pass pass(fields, k);
            if (pass.empty()) break;
            Advector::advect(step, pass.groups(), work_);
        }
    });
    for (const AdvectedField& field : fields) boundary.fill(*field.to);
}

}  // namespace whorl
