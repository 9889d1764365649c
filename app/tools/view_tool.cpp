#include "app/tools/view_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/tools/list.h"

namespace whorl::app {
namespace {

constexpr KeyHelp mouse[] = {{"Ctrl+wheel, + and -", "closer, and away"},
                             {"Middle-drag, Alt-drag", "move what is shown"}};
constexpr KeyHelp keys[] = {{"0", "the whole domain"}, {"Tab", "hold: the other lane, where one is shown"}};

constexpr double reach_pixels = 7;  // from the line, on either side

}  // namespace

bool on_wipe_line(const FieldViewports& place, double x, double y) {
    if (!place.wipe || place.covered) return false;
    const PixelRect& rect = place.tiles.front().rect;
    return y >= rect.y && y < rect.y + rect.height &&
           std::abs(x - static_cast<double>(*place.wipe)) <= reach_pixels;
}

bool ViewTool::take(const InputEvent& event, const FieldViewports& place) {
    using Kind = InputEvent::Kind;
    switch (event.kind) {
        case Kind::Press:
            return press(event, place);
        case Kind::Move: {
            const bool mine = drag_ != Drag::None;
            if (mine) move(event, place);
            x_ = event.x;
            y_ = event.y;
            return mine;
        }
        case Kind::Release:
            if (drag_ == Drag::None || event.code != button_) return false;
            drag_ = Drag::None;
            return true;
        case Kind::Wheel:
            if ((event.mods & GLFW_MOD_CONTROL) == 0) return false;
            if (place.at(event.x, event.y) != nullptr)
                view_.window = place.zoomed_about(view_.window, event.x, event.y, event.turn);
            return true;
        case Kind::Character:
            if (event.code == '+' || event.code == '=') {
                view_.window = place.zoomed_about(view_.window, x_, y_, 1);
            } else if (event.code == '-') {
                view_.window = place.zoomed_about(view_.window, x_, y_, -1);
            } else if (event.code == '0') {
                view_.window = {};
            } else {
                return false;
            }
            return true;
        case Kind::Key:
            if (event.code != GLFW_KEY_TAB || ImGui::GetIO().WantTextInput) return false;
            if (!event.repeated) view_.peek = true;
            return true;
        case Kind::KeyUp:
            if (event.code != GLFW_KEY_TAB) return false;
            view_.peek = false;
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

void ViewTool::move(const InputEvent& event, const FieldViewports& place) {
    const FieldTile* tile = place.of(lane_);
    if (tile == nullptr) return;
    if (drag_ == Drag::Wipe) {
        const double part = (event.x - tile->rect.x) / tile->rect.width;
        view_.wipe = static_cast<float>(std::clamp(part, 0.0, 1.0));
    } else {
        const glm::dvec2 by =
            FieldViewports::part(*tile, x_, y_) - FieldViewports::part(*tile, event.x, event.y);
        view_.window = panned(view_.window, glm::vec2(by));
    }
}

bool ViewTool::hover(const FieldViewports& place) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (on_wipe_line(place, static_cast<double>(mouse.x), static_cast<double>(mouse.y)))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    return false;
}

const ToolEntry view_tool{
    .key = "view", .mouse = mouse, .keys = keys, .make = [](const Services& s) -> std::unique_ptr<Tool> {
        return std::make_unique<ViewTool>(s.view);
    }};

}  // namespace whorl::app
