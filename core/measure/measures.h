// The numbers of one step: conservation, energy, enstrophy, who took them, extrema.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/measure/flow_sums.h"
#include "core/measure/reduction.h"
#include "core/parallel/pool.h"
#include "core/pressure/solver.h"
#include "core/scene/state.h"

namespace whorl {

/// Errors against an exact solution; not a number where none is known.  [T 5.4, 5.6, 5.7]
struct Errors {
    double L1 = std::numeric_limits<double>::quiet_NaN(), L2 = L1, Linf = L1;
};

/// Nodes whose value a limiter or a clamped interpolation changed in a step, the faces of both directions for
/// the velocity; NaN where that is not moved, or was not watched.
struct LimiterCounts {
    double density = std::numeric_limits<double>::quiet_NaN();
    double velocity = std::numeric_limits<double>::quiet_NaN();
};

/// What one phase did in a step, in all its parts together. All phases together are the change since the last
/// step ended: the first has what brush and obstacles did since then too. A change of grid is nobody's and is
/// left out.
struct PhaseShare {
    double ms = 0;
    double energy = 0, enstrophy = 0;  ///< added to ½∫|u|² and ½∫ω²; NaN where the flow is given
};

struct Measures {
    long step = 0;
    double time = 0;
    /// Of each scalar that is counted, 100 ∫q over what was put in; NaN if nothing was.  [T 5.5]
    std::vector<double> percent;
    double kinetic_energy = 0;  ///< ½ ∫|u|², from face velocities
    double enstrophy = 0;       ///< ½ ∫ω²
    /// Of the last step's advection, length²/time; NaN before the first step, in still air, where the flow is
    /// given.
    double effective_viscosity = std::numeric_limits<double>::quiet_NaN();
    double divergence_before = 0, divergence_after = 0;  ///< max |∇·u| around the projection, 1/time
    double relative_divergence = 0;                      ///< max |∇·u| h / |u|max after the projection
    double min_density = 0, max_density = 0;
    double cfl = 0;  ///< |u|max Δt / h
    Errors errors;
    LimiterCounts limited;  ///< by the last step
    double step_ms = 0;     ///< that the last step took, ms
    std::string_view
        pressure_unsupported_reason;  ///< why another pressure solver than the chosen one acted, or empty
    SolveReport pressure;             ///< of the last projection; its solver's key is empty if there was none
    double removed_mean = 0;          ///< divergence taken out of a closed component, 1/time
    std::vector<Reduced> reduced;     ///< what was asked for beside all that

    /// The phases of the last step by their keys, in order; at the start they have done nothing.
    std::vector<std::pair<std::string_view, PhaseShare>> phases;

    double density_percent() const { return percent_of(0); }
    /// @param k  of a scalar; NaN if it is not counted
    double percent_of(std::size_t k) const {
        return k < percent.size() ? percent[k] : std::numeric_limits<double>::quiet_NaN();
    }
    /// What a phase did in the last step; all NaN where it had none of that key.
    PhaseShare phase(std::string_view key) const;
    /// Adds what a part of a phase did.
    void add(std::string_view phase, const PhaseShare& did);
};

/// Names the first field that holds a value that is not finite, and where; empty if all is well.
std::string not_finite(const State& state);

/// What is summed over a row of cells; rows are added up in order, so that threads do not change the result.
struct RowSums {
    double density = 0, temperature = 0;
    double min = std::numeric_limits<double>::infinity(), max = -min, speed = 0;
};

/// Measures states; keeps its scratch from step to step.
class StateReducer {
  public:
    /// Kinetic energy and enstrophy. @param velocity ghosts filled
    FlowSums flow(const FaceVelocity& velocity, const Boundary& boundary, Pool& pool) {
        return flow_.measure(velocity, boundary, pool);
    }
    /// Fills in all that depends on the state alone. @param flow what `flow` says of its velocity
    void measure(const State& state, const FlowSums& flow, double dt, Pool& pool, Measures& out);
    /// Whether every number of the last measured state was finite.
    bool finite() const { return finite_; }

  private:
    FlowReducer flow_;
    std::vector<RowSums> rows_;
    bool finite_ = true;
};

/// The viscosity ν that would take as much energy: in a viscous flow dE/dt = −ν 2Z.
/// @param energy_change ΔE of the advection; one that gains energy has a negative viscosity
/// @param enstrophy     Z = ½ ∫ω² of the velocity that the advection started from
/// @return −ΔE / (Δt 2Z), length²/time; NaN where Z is 0
double effective_viscosity(double energy_change, double enstrophy, double dt);

/// The same of several advections in one step: −Σ ΔE / Σ Δt 2Z.
class Dissipation {
  public:
    void add(double energy_change, double enstrophy, double dt) {
        energy_ += energy_change;
        enstrophy_ += enstrophy * dt;
    }
    double viscosity() const { return effective_viscosity(energy_, enstrophy_, 1); }

  private:
    double energy_ = 0, enstrophy_ = 0;
};

/// L1 = Σ|q−Q| h^d, L2 = √(Σ(q−Q)² h^d), L∞ = max|q−Q|, over the fluid's cells.  [T 5.4, 5.6, 5.7]
/// @param q, reference at centres
Errors errors(const Field& q, const Field& reference, const Boundary& boundary);

}  // namespace whorl
