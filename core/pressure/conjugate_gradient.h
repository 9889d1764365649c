// Pressure by conjugate gradient with an incomplete factor.
#pragma once

#include "core/pressure/poisson.h"
#include "core/pressure/solver.h"

namespace whorl {

/// Conjugate gradient [T sec. 2.2], preconditioned by modified incomplete Cholesky of level 0, MIC(0)
/// [Bridson 2015, fig. 5.5 and 5.6]. The matrix stays implicit; the factor takes five numbers a cell. Faces
/// around a periodic domain's seam are left out of the factor, not of the matrix. One thread: each cell of
/// the factor's solve waits for the one before it.
class ConjugateGradient : public PressureSolver {
  public:
    static constexpr SchemeInfo info{
        "conjugate-gradient", "Conjugate gradient, MIC(0)", "thesis sec. 2.2; Bridson",
        "Iterates from the last pressure to the tolerance; more often on finer grids."};

    void prepare(const Boundary& boundary, Pool& pool) override;
    SolveReport solve(std::span<const double> b, double enough, std::span<double> p, Pool& pool) override;

  private:
    void precondition();

    Poisson poisson_;
    /// 1 / the factor's diagonal, and what its rows and columns are to a neighbour when scaled by it; 0 where
    /// there is none.
    std::vector<double> root_, west_, south_, east_, north_;
    std::vector<double> r_, z_, direction_, product_, zeros_;
    double setup_ms_ = 0;
};

}  // namespace whorl
