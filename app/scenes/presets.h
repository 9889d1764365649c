// The scenes that come with the program.
#pragma once

#include <span>
#include <string_view>

#include "core/scene/scene.h"

namespace whorl::app {

/// A scene file of app/scenes, embedded.
struct Preset {
    std::string_view key;   ///< the file's name
    std::string_view text;  ///< TOML
    Scene scene() const;
};

/// All presets, in the order of the keys 1 to 9.
std::span<const Preset> presets();

/// The scene called `name`: a preset, an experiment, or a scene file where the name ends in .toml or has a
/// slash.
/// @throws InputError that names the nearest keys, or what is wrong in the file
Scene find_scene(std::string_view name);

}  // namespace whorl::app
