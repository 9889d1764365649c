// What a pressure solver is: prepared once a boundary, then solving once a step.
#pragma once

#include <memory>
#include <span>

#include "core/grid/boundary.h"
#include "core/parallel/pool.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// What a solve cost and how well it went.
struct SolveReport {
    int iterations = 0;   ///< 0 for a direct solver
    double residual = 0;  ///< max |b − A p| over max |b|
    double setup_ms = 0;  ///< of the last preparation
    double solve_ms = 0;
};

/// Solves A p = b, where (A p)_c = Σ (p_c − p_n) over the open faces between fluid cells c and n: the
/// Laplacian times −h², symmetric, singular once for each connected component of fluid.
class PressureSolver {
  public:
    virtual ~PressureSolver() = default;

    /// Looks at the domain; may take long, and allocates all that solving needs.
    virtual void prepare(const Boundary& boundary, Pool& pool) = 0;

    /// @param b nx × ny, row by row, 0 in solid cells, of mean 0 over each component
    /// @param p nx × ny, the last solution on entry, the new one on return; any constant may be added to it
    /// on a
    ///          component
    virtual SolveReport solve(std::span<const double> b, std::span<double> p, Pool& pool) = 0;
};

/// A solver by name, and how to make one.
struct PressureSolverEntry {
    SchemeInfo info;
    std::unique_ptr<PressureSolver> (*create)(double tolerance);
};

/// All pressure solvers; the first one is the default.
std::span<const PressureSolverEntry> pressure_solvers();

}  // namespace whorl
