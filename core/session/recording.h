// A run as a value: how it begins, and every command with the step at which it acted.
#pragma once

#include <cstdint>
#include <vector>

#include "core/session/command.h"

namespace whorl {

/// A command that acts once `step` steps are done. Never a Restart: that begins another recording.
struct TimedCommand {
    long step = 0;
    Command command;
    bool operator==(const TimedCommand&) const = default;
};

struct Recording {
    Setup setup;
    std::vector<TimedCommand> commands{};  ///< in the order in which they acted
    long step = 0;                         ///< where the run stood when it was recorded
    std::uint64_t digest = 0;              ///< of the session there; 0 where it is not known
    bool operator==(const Recording&) const = default;

    /// Commands that a recording may hold: half an hour of drawing without a pause.
    static constexpr std::size_t max_commands = 100'000;
    /// Furthest step of a recording.
    static constexpr long max_step = 10'000'000;
};

}  // namespace whorl
