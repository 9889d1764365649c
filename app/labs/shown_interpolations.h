// Which interpolations a lab shows.
#pragma once

#include <vector>

#include "core/interpolation/interpolation.h"

namespace whorl::app {

/// On or off for every interpolation of the list.
using ShownInterpolations = std::vector<bool>;

inline ShownInterpolations all_interpolations() {
    return ShownInterpolations(Interpolation::list().all().size(), true);
}

}  // namespace whorl::app
