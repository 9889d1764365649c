#include "core/pressure/solver_keeper.h"

#include <utility>

#include "core/pressure/automatic.h"

namespace whorl {

int SolverKeeper::projections_to_prepare(const Grid& grid) {
    constexpr int cells_a_projection = 4000;
    return 1 + grid.nx * grid.ny / cells_a_projection;
}

void SolverKeeper::choose(std::size_t index) {
    if (chosen_ && index == index_) return;
    index_ = index;
    chosen_ = entry().create();
    prepared_ = false;
}

void SolverKeeper::follow(const Boundary& boundary, Change change, Pool& pool) {
    const bool anew = !prepared_ || change == Change::Domain;
    prepared_ = true;
    if (!anew && change == Change::None) {
        if (!returns_) return;
        ++at_rest_;
        if (at_rest_ == projections_at_rest) prepare_later(boundary);
        if (at_rest_ < projections_at_rest + projections_to_prepare(boundary.grid())) return;
        chosen_ = coming_.get();
        standing_in_ = returns_ = false;
        return;
    }
    const std::string_view refusal = entry().refuses(boundary);
    const bool refused = !refusal.empty();
    why_not_ = refused ? refusal : "the walls have just changed";
    returns_ = !anew && !refused && entry().slow_to_prepare;
    standing_in_ = refused || returns_;
    at_rest_ = 0;
    if (standing_in_) {
        if (!stand_in_) stand_in_ = std::make_unique<Automatic>();
        stand_in_->prepare(boundary, pool);
    } else {
        chosen_->prepare(boundary, pool);
    }
}

/// One preparation at a time: one that walls have outdated since is waited for on the new one's thread.
void SolverKeeper::prepare_later(const Boundary& boundary) {
    coming_ = std::async(std::launch::async,
                         [create = entry().create, boundary, outdated = std::move(coming_)]() mutable {
                             if (outdated.valid()) outdated.wait();
                             Pool alone(1);
                             std::unique_ptr<PressureSolver> solver = create();
                             solver->prepare(boundary, alone);
                             return solver;
                         });
}

}  // namespace whorl
