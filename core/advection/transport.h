// What carries out an advector's steps.
#pragma once

#include <span>

#include "core/advection/scheme_set.h"
#include "core/grid/boundary.h"
#include "core/parallel/pool.h"

namespace whorl {

struct Workspace;

/// A field as it was, and as it shall be.
struct AdvectedField {
    const Field* from;
    Field* to;
};

/// What a transport is made ready for.
struct TransportSetup {
    SchemeSet schemes;
    int dimensions = 2;
    std::uint64_t seed = 1;  ///< of shapes that are seeded
    Isa isa = best_isa();
    bool shares_particles = true;  ///< among neighbouring nodes, where they lie on a lattice
    bool operator==(const TransportSetup&) const = default;
};

/// What one step of advection goes by.
struct AdvectionStep {
    const FaceVelocity* velocity;  ///< at the step's start, ghosts filled, length/time
    const Boundary* boundary;
    Pool* pool;
    double dt;  ///< time; negative moves backwards
};

/// One for each set of schemes in use.
class Transport {
  public:
    Transport() = default;
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;
    virtual ~Transport() = default;

    /// Makes ready for steps.
    virtual void prepare(const TransportSetup& setup) = 0;
    /// One step. Fields have their ghosts filled; those of results are filled later. Allocates nothing but in
    /// its first step.
    virtual void advect(std::span<const AdvectedField> fields, const AdvectionStep& step) = 0;
    /// What the last step of one field left of a predictor-corrector's way; null for other schemes.
    virtual const Workspace* workspace() const { return nullptr; }
};

}  // namespace whorl
