// Which tunables have an effect with the schemes that are chosen, and why the others have none.
#pragma once

#include <string>

#include "core/scene/parameters.h"

namespace whorl::app {

/// Why a parameter changes nothing in this scene, one line; empty if it does.
std::string inactive_reason(const Parameter& parameter, const Scene& scene);

}  // namespace whorl::app
