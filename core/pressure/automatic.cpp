#include "core/pressure/automatic.h"

#include "core/pressure/diagonalization.h"
#include "core/pressure/multigrid.h"

namespace whorl {

void Automatic::prepare(const Boundary& boundary, Pool& pool) {
    const Grid& grid = boundary.grid();
    const bool direct =
        grid.nx + grid.ny < diagonalization_ends && Diagonalization::unsupported_reason(boundary).empty();
    if (direct) {
        if (!diagonalization_) diagonalization_ = std::make_unique<Diagonalization>();
        chosen_ = diagonalization_.get();
    } else {
        if (!multigrid_) multigrid_ = std::make_unique<Multigrid>();
        chosen_ = multigrid_.get();
    }
    chosen_->prepare(boundary, pool);
}

}  // namespace whorl
