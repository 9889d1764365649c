// Making the velocity divergence-free.
#pragma once

#include <memory>
#include <vector>

#include "core/pressure/components.h"
#include "core/pressure/solver.h"

namespace whorl {

/// What one projection did.
struct ProjectionReport {
    SolveReport solve;
    double divergence_before = 0;  ///< max |∇·u*|, 1/time
    double divergence_after = 0;   ///< max |∇·u|, 1/time
    double largest_speed = 0;      ///< max over faces of |u|, |v| after, length/time
    double removed_mean = 0;       ///< the largest mean divergence taken out of a component, 1/time
};

/// Projection: ∇·(∇p) = (ρ₀/Δt) ∇·u*, u = u* − (Δt/ρ₀) ∇p, ρ₀ = 1.  [T 2.17b; F 48–59, with the factor Δt
/// that F 54–56 lose]
class Projection {
  public:
    /// Chooses the solver by its index in pressure_solvers(); it is prepared at the next projection.
    void set_solver(std::size_t index, double tolerance);

    /// @param velocity u* on entry, ghosts any; u on return, ghosts filled, normal velocity 0 on closed faces
    /// @param dt       time, not 0
    /// @param pressure at centres; solid cells hold their nearest fluid value
    ProjectionReport project(FaceVelocity& velocity, double dt, const Boundary& boundary, Field& pressure,
                             Pool& pool);

  private:
    std::size_t index_ = 0;
    double tolerance_ = 0;
    std::unique_ptr<PressureSolver> solver_;
    Components components_;
    Grid prepared_grid_;
    bool prepared_periodic_ = false;
    std::vector<std::uint8_t> prepared_solids_;
    std::vector<double> right_, p_;
};

/// ∇·u of cell (i, j), 1/time.  [F 50]
/// @param velocity ghosts filled
inline double divergence(const FaceVelocity& velocity, int i, int j, double h) {
    return (static_cast<double>(velocity.u(i + 1, j)) - static_cast<double>(velocity.u(i, j)) +
            static_cast<double>(velocity.v(i, j + 1)) - static_cast<double>(velocity.v(i, j))) /
           h;
}

}  // namespace whorl
