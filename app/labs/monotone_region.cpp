#include "app/labs/monotone_region.h"

#include <cmath>
#include <numbers>

namespace whorl::app {

glm::dvec2 region_boundary(double part) {
    constexpr double pi = std::numbers::pi;
    const double angle = (4 * part - 1) * pi / 3;
    return {2 + 2 * std::cos(angle), 2 + 2 * std::cos(angle - 2 * pi / 3)};
}

}  // namespace whorl::app
