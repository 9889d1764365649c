// Scenes as TOML: the parameters' own keys, and tables of emitters and obstacles.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace whorl {

/// The format's version, written as `whorl = 1`.
inline constexpr int scene_version = 1;

/// Reads a scene. Keys that are not given keep what the scene's experiment sets.
/// @param name what errors call the text: a path or a preset
/// @throws InputError with `name:line:column: reason`
Scene parse_scene(std::string_view text, std::string_view name);

/// @throws InputError if the file cannot be read, is larger than any scene, or as parse_scene
Scene read_scene(const std::filesystem::path& path);

/// All of a scene, so that parse_scene gives it back.
std::string write_scene(const Scene& scene);

}  // namespace whorl
