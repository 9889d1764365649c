// Strokes of the brush that make cells solid, or fluid again.
#pragma once

#include "core/sources/edit.h"
#include "core/sources/stroke.h"

namespace whorl {

/// Makes the cells near a segment solid, or fluid again. What scalars lose in new solid cells counts as
/// taken out; new fluid cells hold still air.
struct ObstacleStroke {
    Segment along;
    double radius = 2;  ///< length
    bool solid = true;
    bool operator==(const ObstacleStroke&) const = default;

    operator Edit() const;  // NOLINT(google-explicit-constructor): it is that edit
};

}  // namespace whorl
