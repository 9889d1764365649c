#include "app/ui/field_viewports.h"

#include <cmath>

namespace whorl::app {

ViewWindow FieldViewports::zoomed_about(const ViewWindow& shown, double x, double y, double notches) const {
    constexpr double notch = 1.25;  // closer by this with each
    const FieldTile* tile = at(x, y);
    const glm::dvec2 about = tile != nullptr ? part(*tile, x, y) : glm::dvec2(0.5);
    return zoomed(shown, glm::vec2(about), static_cast<float>(std::pow(notch, notches)), cells);
}

}  // namespace whorl::app
