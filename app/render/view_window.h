// The part of a domain that is looked at: zoom and pan.
#pragma once

#include <glm/vec2.hpp>

namespace whorl::app {

/// The part of the domain that is shown, as fractions of its sides from the lower left corner. Share one
/// value between views to link their zoom.
struct ViewWindow {
    glm::vec2 low{0.0f, 0.0f};
    glm::vec2 high{1.0f, 1.0f};

    bool whole() const { return low == glm::vec2(0.0f) && high == glm::vec2(1.0f); }
};

/// Cells across the shorter side of the closest view.
inline constexpr float closest_cells = 3.0f;

/// The window seen closer, both sides by the same factor, the place `about` held where it is as far as the
/// domain's edges allow.
/// @param about   what stays under the pointer, as fractions of the window from its lower left corner
/// @param factor  above 1 goes closer, to `closest_cells` at most; below 1 away, to the whole domain at most
/// @param cells   size of the domain, cells; of the finest one if several share the window
ViewWindow zoomed(const ViewWindow& window, glm::vec2 about, float factor, glm::ivec2 cells);

/// The window moved inside the domain, its size kept.
/// @param by  fractions of the window: what was at (by) from its lower left corner comes to lie in that
/// corner
ViewWindow panned(const ViewWindow& window, glm::vec2 by);

}  // namespace whorl::app
