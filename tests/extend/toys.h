// Entries that only tests know, and how to list them.
#pragma once

#include "core/advection/advector.h"

namespace whorl::test {

/// Lists an interpolation, a tracer, a limiter, a stencil, weights, sides, and two advectors with memory.
/// Once, before the first scene.
void list_toys();

/// Advectors that remember: the mean of what each node has held, and particles with positions and values.
extern const Advector running_mean, drifting_particles;

}  // namespace whorl::test
