// Kinetic energy and enstrophy of a flow, in one pass over the velocity.
#pragma once

#include <vector>

#include "core/grid/boundary.h"
#include "core/measure/vorticity.h"
#include "core/parallel/isa.h"
#include "core/parallel/pool.h"

namespace whorl {

/// Sums over the fluid.
struct FlowSums {
    double kinetic_energy = 0;  ///< ½ ∫|u|², each face half to either cell, length²/time² · length^d
    double enstrophy = 0;       ///< ½ ∫ω², ω at centres, 1/time² · length^d

    FlowSums& operator+=(const FlowSums& other) {
        kinetic_energy += other.kinetic_energy;
        enstrophy += other.enstrophy;
        return *this;
    }
    friend FlowSums operator-(const FlowSums& a, const FlowSums& b) {
        return {a.kinetic_energy - b.kinetic_energy, a.enstrophy - b.enstrophy};
    }
};

/// Measures flows; keeps its sums of rows, which are added up in order, so that threads do not change the
/// result.
class FlowReducer {
  public:
    explicit FlowReducer(Isa isa = best_isa());

    /// @param velocity ghosts filled
    FlowSums measure(const FaceVelocity& velocity, const Boundary& boundary, Pool& pool);

  private:
    using AddCells = void (*)(const FaceRows&, int count, Real quarter_over_h, FlowSums&);

    AddCells add_cells_;
    std::vector<FlowSums> rows_;
};

}  // namespace whorl
