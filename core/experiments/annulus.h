// The shape of the thesis' tests, and flows of theirs.
#pragma once

#include "core/scene/state.h"

namespace whorl {

/// q = (1 − s²)² for |s| < 1, else 0, with s = (r − 6)/2: an annulus of radii 4 and 8.  [T sec. 5.1]
/// @param r distance to the centre, length
double annulus(double r);

/// The annulus around a centre in a periodic domain (length units). In one dimension y does not count.
void write_annulus(const Grid& grid, WorldPoint centre, Field& q);

/// The tests' common setup: [0, 40]², periodic, N = 40, Δt = 1/60, 1200 steps.  [T sec. 5.1]
void thesis_test(Scene& scene);

/// The same velocity everywhere, length/time.
void write_uniform_flow(double u, double v, FaceVelocity& velocity);

}  // namespace whorl
