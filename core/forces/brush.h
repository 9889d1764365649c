// The brush: strokes of smoke, pushes and obstacles along a segment.
#pragma once

#include "core/scene/state.h"

namespace whorl {

/// One stretch of a drag: from one point to another (length units) in one step, so that quick strokes leave a
/// continuous trail.
struct Segment {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool operator==(const Segment&) const = default;
};

/// Brings scalars to the stroke's amounts, each as its Source says, and drags the fluid along: everything
/// fades from the segment's line to `radius`. Counts the change of totals as injected.
struct SmokeStroke {
    Segment along;
    double radius = 2;  ///< length
    Amounts amounts{};
    double push = 0;                        ///< share of `velocity` that the fluid takes
    double velocity_x = 0, velocity_y = 0;  ///< of the mouse, length/time
    bool smoke = true;                      ///< false only pushes
    bool operator==(const SmokeStroke&) const = default;
};
void apply(const SmokeStroke& stroke, State& state);

/// Makes the cells near a segment solid, or fluid again. What scalars lose in new solid cells counts as
/// taken out; new fluid cells hold still air.
struct ObstacleStroke {
    Segment along;
    double radius = 2;  ///< length
    bool solid = true;
    bool operator==(const ObstacleStroke&) const = default;
};
void apply(const ObstacleStroke& stroke, State& state, const Scene& scene);

}  // namespace whorl
