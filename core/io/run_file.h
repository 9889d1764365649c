// Runs as TOML: a scene, and where there are any its lanes, its commands, and the step it stood at.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/session/recording.h"

namespace whorl {

/// The format's version, written as `whorl = 1`.
inline constexpr int run_version = 1;

/// The keyword of a picture's text chunk that holds its run.
inline constexpr const char* run_chunk = "Whorl run";

/// The longest text that is read, bytes.
inline constexpr std::size_t max_run_bytes = std::size_t{16} << 20;

/// Reads a run. A scene alone is a run of one lane and no commands. Keys that are not given keep what the
/// scene's experiment sets.
/// @param name what errors call the text: a path or a preset
/// @throws InputError with `name:line:column: reason`
Recording parse_run(std::string_view text, std::string_view name);

/// The text of a run's file.  @throws InputError if it cannot be read or is larger than any run
std::string read_run_text(const std::filesystem::path& path);

/// All of a run, so that parse_run gives it back.
std::string write_run(const Recording& recording);

/// Lanes without a scene: a comparison that suits any.
struct Lanes {
    std::string title;
    std::vector<LaneSetup> lanes;
    int reference = no_reference;
};

/// Reads the lanes of a text, which may be a whole run's.  @throws InputError as parse_run, or if there are
/// none
Lanes parse_lanes(std::string_view text, std::string_view name);

}  // namespace whorl
