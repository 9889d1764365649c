// What carries out an advector's steps, and what it may remember from one to the next.
#pragma once

#include <span>

#include "core/advection/scheme_set.h"
#include "core/base/archive.h"
#include "core/grid/boundary.h"
#include "core/grid/cell_range.h"
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
    std::uint64_t seed = 1;  ///< of what is random
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

/// One for each set of schemes in use. The fields of its steps are always the same ones, in the same order,
/// until it is seeded again.
class Transport {
  public:
    Transport() = default;
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;
    virtual ~Transport() = default;

    /// Makes ready for steps. The setup's advector is this transport's.
    /// @return whether a memory from before is still of use; else it will be seeded anew
    virtual bool prepare(const TransportSetup& setup) = 0;
    /// One step. Fields have their ghosts filled; those of results are filled afterwards. Allocates nothing
    /// but in the first step.
    virtual void advect(std::span<const AdvectedField> fields, const AdvectionStep& step) = 0;
    /// What the last step of one field left of a predictor-corrector's way; null for other schemes.
    virtual const Workspace* workspace() const { return nullptr; }

    // Memory beside the fields: for advectors with the trait `memory`.

    /// Fills the memory from fields, before a step: at the start, after a switch, on another grid. What
    /// forces and projection do between steps a memory sees as the difference from what it wrote itself.
    virtual void seed(std::span<const AdvectedField>, const AdvectionStep&) {}
    /// Brush, emitters or walls changed what fields hold in these cells and on their faces. Values there are
    /// those of the fields from now on.
    virtual void edited(const CellRange&) {}
    /// Passes every number of the memory: for checkpoints and digests.
    virtual void archive(Archive&) {}
};

/// Passes a field with its ghosts.
void archive_field(Archive& archive, std::string_view name, Field& field);

}  // namespace whorl
