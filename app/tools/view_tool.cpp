#include "app/tools/view_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

namespace whorl::app {
namespace {

constexpr double notch = 1.25;      // closer by this with each notch of the wheel
constexpr double reach_pixels = 7;  // from the line, on either side

}  // namespace

bool on_wipe_line(const FieldViewports& place, double x, double y) {
    if (!place.wipe || place.covered) return false;
    const PixelRect& rect = place.tiles.front().rect;
    return y >= rect.y && y < rect.y + rect.height &&
           std::abs(x - static_cast<double>(*place.wipe)) <= reach_pixels;
}

bool ViewTool::take(const InputEvent& event, const FieldViewports& place, ViewSettings& view) {
    using Kind = InputEvent::Kind;
    switch (event.kind) {
        case Kind::Press:
            return press(event, place);
        case Kind::Move: {
            const bool mine = drag_ != Drag::None;
            if (mine) move(event, place, view);
            x_ = event.x;
            y_ = event.y;
            return mine;
        }
        case Kind::Release:
            if (drag_ == Drag::None || event.code != button_) return false;
            drag_ = Drag::None;
            return true;
        case Kind::Wheel:
            // Without a brush the wheel is free.
            if ((event.mods & GLFW_MOD_CONTROL) == 0 && !view.labs.inspector.open) return false;
            if (place.at(x_, y_) != nullptr) zoom(event.y, place, view);
            return true;
        case Kind::Character:
            if (event.code == '+' || event.code == '=') {
                zoom(1, place, view);
            } else if (event.code == '-') {
                zoom(-1, place, view);
            } else if (event.code == '0') {
                view.window = {};
            } else {
                return false;
            }
            return true;
        default:
            return false;
    }
}

bool ViewTool::press(const InputEvent& event, const FieldViewports& place) {
    if (drag_ != Drag::None) return false;
    const bool left = event.code == GLFW_MOUSE_BUTTON_LEFT;
    const FieldTile* tile = place.at(event.x, event.y);
    if (left && event.mods == 0 && on_wipe_line(place, event.x, event.y)) {
        drag_ = Drag::Wipe;
        lane_ = place.tiles.front().lane;
    } else if (tile != nullptr &&
               (event.code == GLFW_MOUSE_BUTTON_MIDDLE || (left && (event.mods & GLFW_MOD_ALT) != 0))) {
        drag_ = Drag::Pan;
        lane_ = tile->lane;
    } else {
        return false;
    }
    button_ = event.code;
    x_ = event.x;
    y_ = event.y;
    return true;
}

void ViewTool::move(const InputEvent& event, const FieldViewports& place, ViewSettings& view) {
    const FieldTile* tile = place.of(lane_);
    if (tile == nullptr) return;
    if (drag_ == Drag::Wipe) {
        const double part = (event.x - tile->rect.x) / tile->rect.width;
        view.wipe = static_cast<float>(std::clamp(part, 0.0, 1.0));
    } else {
        const glm::dvec2 by =
            FieldViewports::part(*tile, x_, y_) - FieldViewports::part(*tile, event.x, event.y);
        view.window = panned(view.window, glm::vec2(by));
    }
}

/// About the pointer, or about the middle where that is on no field.
void ViewTool::zoom(double notches, const FieldViewports& place, ViewSettings& view) const {
    const FieldTile* tile = place.at(x_, y_);
    const glm::dvec2 about = tile != nullptr ? FieldViewports::part(*tile, x_, y_) : glm::dvec2(0.5);
    view.window =
        zoomed(view.window, glm::vec2(about), static_cast<float>(std::pow(notch, notches)), place.cells);
}

}  // namespace whorl::app
