// Making the velocity divergence-free.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/pressure/components.h"
#include "core/pressure/solver_selector.h"

namespace whorl {

/// What one projection did.
struct ProjectionReport {
    SolveReport solve;
    std::string_view solver;              ///< key of the solver that acted
    std::string_view unsupported_reason;  ///< why the chosen one did not; empty if it did
    double divergence_before = 0;         ///< max |∇·u*|, 1/time
    double divergence_after = 0;          ///< max |∇·u|, 1/time
    double largest_speed = 0;             ///< max over faces of |u|, |v| after, length/time
    double removed_mean = 0;              ///< the largest mean divergence taken out of a component, 1/time
};

/// Projection: ∇·(∇p) = (ρ₀/Δt) ∇·u*, u = u* − (Δt/ρ₀) ∇p, ρ₀ = 1.  [T 2.17b; F 48–59, with the factor Δt
/// that F 54–56 lose]
///
/// A mean divergence of a component, which no pressure removes, stays: an emitter in a wall, a source.
/// Allocates when the boundary changes, else nothing. The last pressure is where an iteration starts, so that
/// a projection depends on those before it.
class Projection {
  public:
    /// Chooses the solver by its index in pressure_solvers(); it is prepared at the next projection.
    /// @param tolerance bound of |∇·u| h / |u|max after, and of the residual over the right side's largest
    /// value;
    ///                  direct solvers do better whatever it is
    void set_solver(std::size_t index, double tolerance);

    /// @param velocity u* on entry, ghosts any; u on return, ghosts filled, normal velocity 0 on closed faces
    /// @param dt       time, not 0
    /// @param pressure at centres; solid cells hold their nearest fluid value
    ProjectionReport project(FaceVelocity& velocity, double dt, const Boundary& boundary, Field& pressure,
                             Pool& pool);

    /// What a projection takes from those before it.
    struct Memory {
        std::vector<double> pressure;  ///< where an iteration starts; empty before the first projection
        SolverSelector::Memory solver;
        bool new_walls = false;  ///< the next projection will see walls painted since the last one
    };
    /// @param boundary  of the next projection
    Memory memory(const Boundary& boundary) const {
        return {p_, selector_.memory(), !solids_.empty() && solids_ != boundary.solids()};
    }
    /// Goes on from a memory of the same choice of solver and of this boundary; a default one begins anew.
    void restore(const Memory& memory, const Boundary& boundary, Pool& pool);

  private:
    SolverSelector::Change take(const Boundary& boundary);
    void look_at(const Boundary& boundary, Pool& pool);
    double set_right(const FaceVelocity& velocity, double scale, Pool& pool);
    void correct(FaceVelocity& velocity, double factor, Pool& pool) const;
    double largest_outflow(const FaceVelocity& velocity, Pool& pool);
    double largest_speed(const FaceVelocity& velocity, Pool& pool);
    double largest_of_rows(int rows) const;

    double tolerance_ = 0;
    SolverSelector selector_;
    Components components_;
    Grid grid_;
    Sides sides_;
    std::vector<std::uint8_t> solids_;
    std::vector<double> right_, p_, row_largest_;
};

}  // namespace whorl
