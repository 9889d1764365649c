// Moving fields with the flow: the one way in for every scheme.
#pragma once

#include <optional>

#include "core/advection/stencil.h"
#include "core/advection/step.h"
#include "core/parallel/isa.h"
#include "core/schemes/registry.h"

namespace whorl {

/// The inner loops for a set of schemes in a domain with periodic sides or walls.
Kernels choose_kernels(const SchemeSet& schemes, bool periodic, Isa isa = best_isa());

/// Moves fields by one set of schemes; keeps its stencil and intermediate fields from step to step.
class Mover {
  public:
    /// @param seed of the jittered stencil
    void set(const SchemeSet& schemes, int dimensions, std::uint64_t seed);
    const SchemeSet& schemes() const { return schemes_; }

    /// One step of advection.
    /// @param fields   any number at any sites: at the step's start, ghosts filled, and distinct ones for the
    ///                 result, whose ghosts are filled too; any unit
    /// @param velocity at the step's start, ghosts filled, length/time
    /// @param dt       time; negative moves backwards
    void advect(std::span<const AdvectedField> fields, const FaceVelocity& velocity, double dt,
                const Boundary& boundary, Pool& pool);
    void advect(const Field& from, Field& to, const FaceVelocity& velocity, double dt,
                const Boundary& boundary, Pool& pool) {
        const AdvectedField field{&from, &to};
        advect({&field, 1}, velocity, dt, boundary, pool);
    }

    /// What the last advect left of a predictor-corrector's way: its forward and its corrected fields.
    const Workspace& workspace(std::size_t group) const { return work_[group]; }

  private:
    SchemeSet schemes_;
    int dimensions_ = 0;
    std::uint64_t seed_ = 0;
    std::optional<Stencil> stencil_;
    std::optional<Lattice> lattice_;
    std::vector<LatticeTile> tiles_;  ///< one a thread
    std::array<Workspace, max_groups> work_;
};

}  // namespace whorl
