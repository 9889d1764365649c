// Strokes of the brush that bring smoke and drag the fluid along.
#pragma once

#include "core/sources/edit.h"
#include "core/sources/stroke.h"

namespace whorl {

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

    operator Edit() const;  // NOLINT(google-explicit-constructor): it is that edit
};

}  // namespace whorl
