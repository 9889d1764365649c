// What the last advection began with: the fields that it moved, the flow, and by what schemes.
#pragma once

#include <vector>

#include "core/advection/scheme_set.h"
#include "core/grid/boundary.h"
#include "core/scene/field_list.h"

namespace whorl {

/// How an advection moves its fields.
struct AdvectionSetup {
    SchemeSet velocity, scalars;
    double dt = 0;           ///< time
    std::uint64_t seed = 1;  ///< of the jittered stencil

    /// @pre the field is advected
    const SchemeSet& schemes(FieldId id) const {
        return id.info().advected_by == AdvectedBy::Velocity ? velocity : scalars;
    }
};

/// The last advection of a simulation, or of a copy; refers to fields that are kept there.
struct LastAdvection {
    AdvectionSetup setup;
    const Boundary* boundary = nullptr;
    const FaceVelocity* velocity = nullptr;  ///< the flow that moves everything, ghosts filled
    /// Fields as they were, ghosts filled, and as they are now: after walls, a projection that came later,
    /// and what the brush did since. By FieldId; null, or not there, for what is not moved.
    std::vector<const Field*> before{}, now{};

    const Field* from(FieldId id) const { return id.index() < before.size() ? before[id.index()] : nullptr; }
    const Field* at_present(FieldId id) const { return id.index() < now.size() ? now[id.index()] : nullptr; }
};

}  // namespace whorl
