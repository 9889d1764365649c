#include "core/pressure/solver_selector.h"

#include <utility>

#include "core/pressure/automatic.h"

namespace whorl {
namespace {

constexpr std::string_view just_changed = "the walls have just changed";

}  // namespace

int SolverSelector::projections_to_prepare(const Grid& grid) {
    constexpr int cells_a_projection = 4000;
    return 1 + grid.nx * grid.ny / cells_a_projection;
}

void SolverSelector::choose(std::size_t index) {
    if (chosen_ && index == index_) return;
    index_ = index;
    chosen_ = entry().create();
    prepared_ = false;
}

void SolverSelector::follow(const Boundary& boundary, Change change, Pool& pool) {
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
    const std::string_view refusal = entry().unsupported_reason(boundary);
    const bool refused = !refusal.empty();
    returns_ = !anew && !refused && entry().slow_to_prepare;
    at_rest_ = 0;
    if (refused || returns_) {
        stand_in(boundary, refused ? refusal : just_changed, pool);
    } else {
        standing_in_ = false;
        chosen_->prepare(boundary, pool);
    }
}

void SolverSelector::restore(const Memory& memory, const Boundary& boundary, bool same, Pool& pool) {
    const bool as_it_is = same && this->memory().phase == Phase::Ready && memory.phase == Phase::Ready;
    if (as_it_is) return;
    prepared_ = returns_ = false;
    if (memory.phase == Phase::Fresh) return;
    if (memory.phase == Phase::Ready) return follow(boundary, Change::Domain, pool);
    prepared_ = returns_ = true;
    at_rest_ = memory.at_rest;
    stand_in(boundary, just_changed, pool);
    if (at_rest_ >= projections_at_rest) prepare_later(boundary);
}

void SolverSelector::stand_in(const Boundary& boundary, std::string_view unsupported_reason, Pool& pool) {
    standing_in_ = true;
    unsupported_reason_ = unsupported_reason;
    if (!stand_in_) stand_in_ = std::make_unique<Automatic>();
    stand_in_->prepare(boundary, pool);
}

/// One preparation at a time: one that walls have outdated since is waited for on the new one's thread.
void SolverSelector::prepare_later(const Boundary& boundary) {
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
