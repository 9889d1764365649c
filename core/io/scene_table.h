// A scene as the keys of a TOML table: the parameters' own, and tables of emitters and obstacles.
#pragma once

#include <iosfwd>
#include <span>

#include "core/io/toml_reader.h"
#include "core/scene/scene.h"

namespace whorl {

/// Reads a scene. Keys that are not given keep what the scene's experiment sets; whether its choices go
/// together is not asked.
/// @param others  keys that are none of the scene's
/// @throws InputError with `name:line:column: reason`
Scene read_scene_table(const TomlReader& reader, const toml::table& table,
                       std::span<const std::string_view> others);

/// All of a scene, so that read_scene_table gives it back. Tables of emitters and obstacles end it.
void write_scene_table(const Scene& scene, std::ostream& out);

}  // namespace whorl
