// What a person can do to a running simulation, as values: input becomes commands that act between steps.
#pragma once

#include <string>
#include <variant>

#include "core/forces/brush.h"

namespace whorl {

/// Sets a parameter of the table, as `--set key=value` does.
struct SetParameter {
    std::string key;
    std::string value;
    bool operator==(const SetParameter&) const = default;
};
/// Back to the start of the scene as it is now set.
struct Restart {
    bool operator==(const Restart&) const = default;
};

using Command = std::variant<SetParameter, SmokeStroke, ObstacleStroke, Restart>;

}  // namespace whorl
