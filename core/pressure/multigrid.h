// Pressure by conjugate gradient, preconditioned by a multigrid cycle.
#pragma once

#include "core/pressure/multigrid_levels.h"
#include "core/pressure/solver.h"

namespace whorl {

/// Conjugate gradient whose preconditioner is one V-cycle [McAdams et al. 2010, alg. 3]. The cycle and the
/// search direction are single, the pressure, the residual and all sums double: b − A p stays true to
/// rounding, for A times a float direction is exact in double but for rounding. About as many iterations at
/// any size; preparing costs less than solving.
class Multigrid : public PressureSolver {
  public:
    static constexpr SchemeInfo info{
        "multigrid", "Multigrid CG", "McAdams et al. 2010",
        "Conjugate gradient preconditioned by a V-cycle: equally few iterations at any size, any obstacles."};

    void prepare(const Boundary& boundary, Pool& pool) override;
    SolveReport solve(std::span<const double> b, double enough, std::span<double> p, Pool& pool) override;

  private:
    double precondition(Pool& pool);
    double search(float beta, Pool& pool);
    double descend(double alpha, double gain, std::span<double> p, Pool& pool);

    Poisson poisson_;
    Levels levels_;
    std::vector<double> r_;
    PaddedRows direction_, next_direction_;
    std::vector<double> row_sums_;
    double setup_ms_ = 0;
};

}  // namespace whorl
