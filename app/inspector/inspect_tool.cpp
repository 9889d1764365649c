#include "app/inspector/inspect_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace whorl::app {
namespace {

bool with_shift(const InputEvent& event) {
    return (event.mods & GLFW_MOD_SHIFT) != 0;
}

/// By one cell of the grid, inside the domain. @return whether the key is an arrow
bool walk(int key, const Grid& grid, WorldPoint& at) {
    glm::dvec2 by(0);
    if (key == GLFW_KEY_LEFT) by.x = -1;
    if (key == GLFW_KEY_RIGHT) by.x = 1;
    if (key == GLFW_KEY_DOWN) by.y = -1;
    if (key == GLFW_KEY_UP) by.y = 1;
    if (by == glm::dvec2(0)) return false;
    at = {std::clamp(at.x + by.x * grid.h, 0.0, grid.width()),
          std::clamp(at.y + by.y * grid.h, 0.0, grid.height())};
    return true;
}

}  // namespace

bool InspectTool::take(const InputEvent& event, const FieldViewports& place, SessionClient& client,
                       ViewSettings& view) {
    using Kind = InputEvent::Kind;
    Inspector& inspector = view.labs.inspector;
    if (!inspector.open) {
        picking_ = false;
        return false;
    }
    const FieldTile* tile = place.at(event.x, event.y);
    switch (event.kind) {
        case Kind::Press:
            if (event.code != GLFW_MOUSE_BUTTON_LEFT || event.mods != 0 || tile == nullptr) return false;
            picking_ = true;
            inspector.goes_closer = view.window.whole();
            pick(place, *tile, event.x, event.y, client, view);
            return true;
        case Kind::Move:
            if (picking_ && tile != nullptr) pick(place, *tile, event.x, event.y, client, view);
            return picking_;
        case Kind::Release:
            if (!picking_ || event.code != GLFW_MOUSE_BUTTON_LEFT) return false;
            picking_ = false;
            return true;
        case Kind::Key:
            return inspector.picked && with_shift(event) &&
                   walk(event.code, client.snapshot().grid(), inspector.node.at);
        default:
            return false;
    }
}

void InspectTool::pick(const FieldViewports& place, const FieldTile& tile, double x, double y,
                       SessionClient& client, ViewSettings& view) const {
    view.labs.inspector.pick(place.world(tile, x, y));
    client.select(tile.lane);
}

}  // namespace whorl::app
