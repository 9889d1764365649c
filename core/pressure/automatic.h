// The pressure solver that is fastest for the domain at hand.
#pragma once

#include "core/pressure/solver.h"

namespace whorl {

/// Picks by the measurements in docs/performance.md: diagonalization for a domain without obstacles as long
/// as its nx ny (nx + ny) products take less time than a few cycles over nx ny cells, else multigrid. Neither
/// factorises.
class Automatic : public PressureSolver {
  public:
    static constexpr SchemeInfo info{"auto", "Automatic", "",
                                     "Whichever is measured fastest for this size and these walls."};
    /// nx + ny from which multigrid is the faster one without obstacles, too.
    static constexpr int diagonalization_ends = 1280;

    void prepare(const Boundary& boundary, Pool& pool) override;
    SolveReport solve(std::span<const double> b, double enough, std::span<double> p, Pool& pool) override {
        return chosen_->solve(b, enough, p, pool);
    }

  private:
    /// Both stay, so that painting and erasing an obstacle allocates little anew.
    std::unique_ptr<PressureSolver> diagonalization_, multigrid_;
    PressureSolver* chosen_ = nullptr;
};

}  // namespace whorl
