// One step of a set of schemes over stirred fields, with the choices that an Advection makes left to the
// test.
#pragma once

#include <vector>

#include "core/advection/advection.h"

namespace whorl {

struct Domain {
    Grid grid;
    Sides sides;
    bool obstacle = false;
};

/// A velocity and four fields with no symmetry, at most `cfl` cells a step of 1.
struct Stirred {
    Boundary boundary;
    FaceVelocity velocity;
    Field density, temperature;

    Stirred(const Domain& domain, double cfl);
};

/// New ρ, T, u, v.
using Moved = std::vector<Field>;

struct Ways {
    Isa isa = best_isa();
    int threads = 1;
    bool lattice = true;  ///< false: each node traces its own particles
};

/// @param steps over the same workspace
Moved move(const SchemeSet& schemes, const Stirred& from, const Ways& ways, int steps = 1);

/// The largest difference of any two samples that belong to each other, over the largest sample.
double difference(const Moved& a, const Moved& b);

}  // namespace whorl
