#include "app/inspector/inspect_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <imgui.h>

#include <algorithm>

#include "app/inspector/list.h"
#include "app/run/shared_state.h"

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

bool InspectTool::take(const InputEvent& event, const FieldViewports& fields) {
    using Kind = InputEvent::Kind;
    if (!inspection_.open) {
        picking_ = false;
        return false;
    }
    const FieldTile* tile = fields.at(event.x, event.y);
    switch (event.kind) {
        case Kind::Press:
            if (event.code != GLFW_MOUSE_BUTTON_LEFT || event.mods != 0 || tile == nullptr) return false;
            picking_ = true;
            inspection_.goes_closer = view_.window.whole();
            pick(fields, *tile, event.x, event.y);
            return true;
        case Kind::Move:
            if (picking_ && tile != nullptr) pick(fields, *tile, event.x, event.y);
            return picking_;
        case Kind::Release:
            if (!picking_ || event.code != GLFW_MOUSE_BUTTON_LEFT) return false;
            picking_ = false;
            return true;
        case Kind::Wheel:
            if (tile != nullptr)
                view_.window = fields.zoomed_about(view_.window, event.x, event.y, event.turn);
            return true;
        case Kind::Key:
            return inspection_.picked && with_shift(event) &&
                   walk(event.code, run_.snapshot().grid(), inspection_.node.at);
        default:
            return false;
    }
}

void InspectTool::pick(const FieldViewports& fields, const FieldTile& tile, double x, double y) const {
    inspection_.pick(fields.world(tile, x, y));
    run_.select(tile.lane);
}

void InspectTool::hover_curves(double x, std::size_t lane) {
    if (!inspection_.open) return;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) run_.select(lane);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) inspection_.pick({x, 0.5 * run_.snapshot().grid().h});
}

std::span<const char* const> InspectTool::hints(bool curves) const {
    static constexpr const char* all[] = {
        "Click a cell to see the sum behind it  ·  wheel goes closer  ·  0 shows all  ·  I ends it",
        "Click a cell  ·  wheel goes closer  ·  I ends it", "Click a cell  ·  I ends it", "Click a cell"};
    if (!inspection_.open) return {};
    // Curves have no zoom.
    return std::span<const char* const>(all).subspan(curves ? 2 : 0);
}

const ToolEntry inspect_tool{
    .key = "inspect", .mouse = {}, .keys = {}, .make = [](const Services& s) -> std::unique_ptr<Tool> {
        return std::make_unique<InspectTool>(s.run, s.view, s.shared.of<Inspection>());
    }};

}  // namespace whorl::app
