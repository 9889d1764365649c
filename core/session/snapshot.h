// A finished step as the window sees it: a copy of what it draws, apart from the running session.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/inspect/explanation.h"
#include "core/session/session.h"
#include "core/session/watch.h"

namespace whorl {

/// One lane.
struct Snapshot {
    Scene scene;
    State state;               ///< ghosts filled
    std::uint64_t memory = 0;  ///< see Simulation::memory_digest
    Field exact;               ///< the exact density, where has_exact
    bool has_exact = false;
    Measures measures;
    // Where that is watched, and known of the last step:
    std::optional<LimiterMasks> limits;
    std::optional<Explanation> explanation;  ///< of the watched node
    std::optional<Watch::Node> watched;      ///< that it is asked for
    std::optional<std::string> failure;      ///< why the lane has stopped; the fields are the last sound ones

    const Grid& grid() const { return state.grid(); }
    const Field& density() const { return state.density(); }
    bool solid(int i, int j) const { return state.boundary.solid(i, j); }
    /// nx × ny, row by row.
    const std::vector<std::uint8_t>& solids() const { return state.boundary.solids(); }
};

/// All lanes at one step.
struct SessionSnapshot {
    Setup setup;                  ///< as it is set now
    std::vector<Snapshot> lanes;  ///< one for each of the setup's
    std::vector<int> ids;         ///< see Session::id
    long step = 0;                ///< of the session
    long last_step = 0;           ///< that can be gone to
    bool complete = true;         ///< whether the recording holds all of the run
    double time = 0;
    std::uint64_t taken = 0;   ///< commands of the player that have been taken, see Player::push
    std::uint64_t serial = 0;  ///< grows with every snapshot
    int run = 0;               ///< grows with every restart and loaded run

    /// As Session::digest, of the lanes' fields as they are here.
    std::uint64_t digest() const;
};

/// Copies a sound lane's present state; allocates only when the grid has changed or a node is watched.
void take_snapshot(const Lane& lane, Pool& pool, Snapshot& out,
                   const std::optional<Watch::Node>& node = std::nullopt);

/// Copies a session's present state; a lane that has stopped keeps the fields of `last`, the snapshot before.
/// Leaves serial and run alone.
void take_snapshot(const Session& session, const SessionSnapshot& last, Pool& pool, SessionSnapshot& out,
                   const std::optional<Watch::Node>& node = std::nullopt);

}  // namespace whorl
