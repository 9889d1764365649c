// What a pressure solver is: prepared once a boundary, then solving once a step.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/base/scheme_info.h"
#include "core/grid/boundary.h"
#include "core/parallel/pool.h"

namespace whorl {

/// What a solve cost and how well it went.
struct SolveReport {
    std::string_view solver;  ///< key of the solver that acted; `auto` names the one it picked
    int iterations = 0;       ///< 0 for a direct solver
    double residual = 0;      ///< max |b − A p| over max |b|, 0 if b is 0
    double setup_ms = 0;      ///< of the last preparation
    double solve_ms = 0;
};

/// Solves A p = b, where (A p)_c = Σ (p_c − p_n) over the open faces between fluid cells c and n: the
/// Laplacian times −h², symmetric, singular once for each connected component of fluid.
class PressureSolver {
  public:
    virtual ~PressureSolver() = default;

    /// Looks at the domain, keeping nothing of the last one's; may take long, and allocates all that solving
    /// needs.
    virtual void prepare(const Boundary& boundary, Pool& pool) = 0;

    /// @param b      nx × ny, row by row, 0 in solid cells, of mean 0 over each component
    /// @param enough the largest |b − A p| at which an iteration may stop, in b's unit; direct solvers go to
    ///               rounding whatever it is
    /// @param p      nx × ny, 0 in solid cells; a guess on entry, the solution on return, to each component
    /// of
    ///               which any constant may have been added
    /// Allocates nothing; the result does not depend on the number of threads.
    virtual SolveReport solve(std::span<const double> b, double enough, std::span<double> p, Pool& pool) = 0;
};

/// A solver by name, how to make one, and where it is of use.
struct PressureSolverEntry {
    SchemeInfo info;
    std::unique_ptr<PressureSolver> (*create)();
    /// Why it is not offered for a boundary; empty where it is.
    std::string_view (*unsupported_reason)(const Boundary& boundary);
    /// Whether preparing takes many times longer than solving, so that it must wait while walls are painted.
    bool slow_to_prepare;
};

/// All pressure solvers; the first one is the default.
std::span<const PressureSolverEntry> pressure_solvers();

}  // namespace whorl
