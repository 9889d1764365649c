#include "core/advection/stateless.h"

#include <algorithm>

namespace whorl {

bool Stateless::prepare(const TransportSetup& setup) {
    setup_ = setup;
    const SchemeSet& schemes = setup_.schemes;
    stencil_.emplace(schemes.stencil, schemes.zeta, schemes.weights, setup_.dimensions, setup_.seed);
    static_assert(Lattice::max_per_cell >= 2 * SchemeSet::max_zeta);
    const bool shares = schemes.affine() && setup_.shares_particles;
    lattice_ = shares ? Lattice::of(stencil_->particles()) : std::nullopt;
    return true;
}

void Stateless::advect(std::span<const AdvectedField> fields, const AdvectionStep& step) {
    if (lattice_) {
        tiles_.resize(static_cast<std::size_t>(step.pool->threads()));
        constexpr auto most = static_cast<int>(max_groups) * Group::max_fields;
        for (LatticeTile& tile : tiles_)
            tile.shape(*lattice_, std::min(static_cast<int>(fields.size()), most));
    }
    const Step base{.kernels = choose_kernels(setup_.schemes, step.boundary->wraps(), setup_.isa),
                    .particles = stencil_->particles(),
                    .lattice = lattice_ ? &*lattice_ : nullptr,
                    .tiles = tiles_,
                    .velocity = step.velocity,
                    .boundary = step.boundary,
                    .pool = step.pool,
                    .dt = static_cast<Real>(step.dt / step.boundary->grid().h)};
    for (int k = 0; true; ++k) {
        const Pass pass(fields, k);
        if (pass.empty()) return;
        advect_(base, pass.groups(), work_);
    }
}

}  // namespace whorl
