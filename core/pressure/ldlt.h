// Pressure by a sparse LDLᵀ factorisation.
#pragma once

#include "core/pressure/solver.h"

namespace whorl {

/// Eigen's SimplicialLDLT with approximate minimum degree ordering [T sec. 2.2; Amestoy, Davis and Duff
/// 1996], factorised when the boundary changes and kept. One cell of each component is pinned to 0, which
/// makes the matrix definite. Exact to rounding.
class Ldlt : public PressureSolver {
  public:
    static constexpr SchemeInfo info{"ldlt", "LDLᵀ (direct)", "thesis sec. 2.2",
                                     "Sparse factorisation, kept until the walls change. Exact to rounding."};

    Ldlt();
    ~Ldlt() override;
    void prepare(const Boundary& boundary, Pool& pool) override;
    SolveReport solve(std::span<const double> b, double enough, std::span<double> p, Pool& pool) override;

    /// Non-zeros of the factor L below its diagonal; each takes 12 bytes.
    std::size_t factor_entries() const;

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace whorl
