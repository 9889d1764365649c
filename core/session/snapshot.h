// A finished step as the window sees it: a copy of what it draws, apart from the running simulation.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/session/lane.h"

namespace whorl {

struct Snapshot {
    Scene scene;
    Grid grid;
    bool periodic = false;
    std::vector<std::uint8_t> solids;  ///< nx × ny, row by row
    FaceVelocity velocity;             ///< ghosts filled
    Field density, temperature, pressure;
    Field speed, vorticity, divergence;  ///< at centres, of the velocity as it stands
    Field exact;                         ///< the exact density, where has_exact
    bool has_exact = false;
    Measures measures;
    std::optional<std::string> failure;  ///< why the lane has stopped; the fields are the last sound ones
    std::uint64_t serial = 0;            ///< grows with every snapshot
    int run = 0;                         ///< grows with every restart and loaded scene
};

/// Copies a sound lane's present state; allocates only when the grid has changed. Leaves serial and run
/// alone.
void take_snapshot(const Lane& lane, Pool& pool, Snapshot& out);

}  // namespace whorl
