#include "app/labs/slice_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <glm/common.hpp>

#include "app/labs/slice_overlay.h"

namespace whorl::app {
namespace {

constexpr float snap_reach = 3;  // points

/// A pixel's place as fractions of the domain.
glm::dvec2 fraction(const FieldViewports& place, const FieldTile& tile, double x, double y) {
    return glm::mix(glm::dvec2(place.window.low), glm::dvec2(place.window.high),
                    FieldViewports::part(tile, x, y));
}

}  // namespace

bool SliceTool::take(const InputEvent& event, const FieldViewports& place, const SessionSnapshot& session,
                     float point, SliceLab& lab) {
    using Kind = InputEvent::Kind;
    const bool holds = lab.held != SliceGrip::None;
    if (event.kind == Kind::Press && !holds) {
        if (!lab.open || event.code != GLFW_MOUSE_BUTTON_LEFT || event.mods != 0) return false;
        const auto hit = hit_slice(lab.line, session, place, {event.x, event.y}, point);
        if (!hit) return false;
        lab.held = hit->grip;
        lane_ = hit->lane;
        began_ = fraction(place, *place.of(lane_), event.x, event.y);
        before_ = lab.line;
        return true;
    }
    if (event.kind == Kind::Release && holds && event.code == GLFW_MOUSE_BUTTON_LEFT) {
        lab.held = SliceGrip::None;
        return true;
    }
    if (event.kind != Kind::Move || !holds) return false;
    const FieldTile* tile = place.of(lane_);
    if (tile == nullptr) return true;
    const glm::dvec2 shown = glm::dvec2(place.window.high) - glm::dvec2(place.window.low);
    const glm::dvec2 near =
        static_cast<double>(snap_reach * point) * shown / glm::dvec2(tile->rect.width, tile->rect.height);
    lab.line = dragged(before_, lab.held, fraction(place, *tile, event.x, event.y) - began_, near,
                       session.lanes[lane_].grid());
    return true;
}

}  // namespace whorl::app
