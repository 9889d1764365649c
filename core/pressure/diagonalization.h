// Pressure by the modes of the one-dimensional Laplacian.
#pragma once

#include "core/pressure/modes.h"
#include "core/pressure/poisson.h"
#include "core/pressure/solver.h"

namespace whorl {

/// Fast diagonalisation [Lynch, Rice and Thomas 1964]: A = X ⊗ 1 + 1 ⊗ Y, so with X = P Λ Pᵀ and Y = Q M Qᵀ
/// the solution is Q ((Qᵀ b P) / (λ + μ)) Pᵀ. Every mode is even or odd, so that rows are folded about their
/// middle first and the four products cost half. Exact to rounding; nx ny (nx + ny) products a solve.
class Diagonalization : public PressureSolver {
  public:
    static constexpr SchemeInfo info{"diagonalization", "Fast diagonalisation", "Lynch, Rice & Thomas 1964",
                                     "Direct solve by dense products, for a domain without obstacles. Exact "
                                     "to rounding."};
    /// Empty without obstacles, else why there can be none.
    static std::string_view unsupported_reason(const Boundary& boundary);

    void prepare(const Boundary& boundary, Pool& pool) override;
    SolveReport solve(std::span<const double> b, double enough, std::span<double> p, Pool& pool) override;

  private:
    /// Even or odd modes of one direction, laid out for the products.
    struct Half {
        int count = 0;
        int stride = 0;                      ///< of `to_modes`, `to_cells`
        std::vector<double> to_modes;        ///< row k: mode k
        std::vector<double> to_cells;        ///< row i: all modes at cell i
        std::vector<double> modes_of_row;    ///< panels: a folded row times these is its modes
        std::vector<double> cells_of_modes;  ///< panels: modes times these are a folded row
        std::vector<double> eigenvalues;
        int panels() const;
    };
    struct Direction {
        int cells = 0;
        bool periodic = false;
        Half even, odd;
        void prepare(int n, bool wraps);
    };

    void rows_to_modes(const double* b, int begin, int end);
    void rows_to_cells(double* p, int begin, int end);
    void solve_panel(int panel, double* folded);

    Poisson poisson_;
    Direction x_, y_;
    int stride_ = 0;               ///< of `folded_` and `modes_`
    std::vector<double> folded_;   ///< rows folded: the even part, then from a panel's edge the odd part
    std::vector<double> modes_;    ///< rows by their modes in x, laid out likewise
    std::vector<double> columns_;  ///< a few columns, folded, and by their modes in y
    double setup_ms_ = 0;
};

}  // namespace whorl
