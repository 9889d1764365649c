// The scenes that come with the program.
#pragma once

#include <span>
#include <string_view>

#include "core/session/recording.h"

namespace whorl::app {

/// A scene file of app/scenes, embedded.
struct Preset {
    std::string_view key;   ///< the file's name
    std::string_view text;  ///< TOML
    Scene scene() const;
};

/// All presets, in the order of the keys 1 to 9.
std::span<const Preset> presets();

/// The run called `name`: a preset, an experiment, or where the name ends in .toml or .png or has a slash, a
/// file of a scene or a run, or a picture that carries one.
/// @throws InputError that names the nearest keys, or what is wrong in the file
Recording find_run(std::string_view name);

}  // namespace whorl::app
