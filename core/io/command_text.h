// Commands as lines of text: `STEP set KEY=VALUE`, `STEP lanes K`, and an edit as its verb and numbers.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/session/recording.h"

namespace whorl {

/// A line a command. Arrangements are written as their index, and appended to `arrangements`.
std::string write_commands(std::span<const TimedCommand> commands, std::vector<Arrange>& arrangements);

/// Reads what write_commands wrote.
/// @param arrangements  what `lanes K` refers to
/// @throws InputError `command LINE: reason`
std::vector<TimedCommand> read_commands(std::string_view text, std::span<const Arrange> arrangements);

}  // namespace whorl
