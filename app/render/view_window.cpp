// See view_window.h.
#include "app/render/view_window.h"

#include <algorithm>
#include <glm/common.hpp>

namespace whorl::app {
namespace {

/// The window of that size nearest to `low` that lies in the domain.
ViewWindow inside(glm::vec2 low, glm::vec2 size) {
    // The far corner from the near one, not from the wish: a window at the edge ends exactly there.
    low = glm::clamp(low, glm::vec2(0.0f), glm::vec2(1.0f) - size);
    return {low, glm::min(low + size, glm::vec2(1.0f))};
}

}  // namespace

ViewWindow zoomed(const ViewWindow& window, glm::vec2 about, float factor, glm::ivec2 cells) {
    const glm::vec2 size = window.high - window.low;
    const float shorter = static_cast<float>(std::min(cells.x, cells.y));
    const float least = std::min(1.0f, closest_cells / shorter);
    const glm::vec2 wanted = glm::clamp(size / factor, glm::vec2(least), glm::vec2(1.0f));
    return inside(window.low + about * (size - wanted), wanted);
}

ViewWindow panned(const ViewWindow& window, glm::vec2 by) {
    const glm::vec2 size = window.high - window.low;
    return inside(window.low + by * size, size);
}

}  // namespace whorl::app
