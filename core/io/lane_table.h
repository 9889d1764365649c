// Lanes as tables of TOML: what each is called, and what it sets otherwise than the scene.
#pragma once

#include <vector>

#include "core/io/toml_reader.h"
#include "core/session/setup.h"

namespace whorl {

/// A lane, and in an arrangement what it goes on from.
struct ReadLane {
    LaneSetup setup;
    int from = 0;
};

/// Reads a list of settings, `["key=value", ...]`, each of which could be made by itself.
/// @throws InputError with `name:line:column: reason`
std::vector<SetParameter> read_settings(const TomlReader& reader, const toml::node& node);

/// @param arranged  whether the table may say what the lane goes on from
/// @throws as read_settings
ReadLane read_lane(const TomlReader& reader, const toml::table& table, bool arranged);

/// All tables of `[[lane]]`.  @throws as read_settings
std::vector<LaneSetup> read_lanes(const TomlReader& reader, const toml::node& node);

/// The place of the lane that others are measured against.  @throws as read_settings
int read_reference(const TomlReader& reader, const toml::node& node);

}  // namespace whorl
