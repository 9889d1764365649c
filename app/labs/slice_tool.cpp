#include "app/labs/slice_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <glm/common.hpp>

#include "app/labs/list.h"
#include "app/labs/slice_overlay.h"
#include "app/run/run_control.h"
#include "app/run/shared_state.h"
#include "app/ui/ui.h"

namespace whorl::app {
namespace {

constexpr float snap_reach = 3;  // points

/// A pixel's place as fractions of the domain.
glm::dvec2 fraction(const FieldViewports& place, const FieldTile& tile, double x, double y) {
    return glm::mix(glm::dvec2(place.window.low), glm::dvec2(place.window.high),
                    FieldViewports::part(tile, x, y));
}

}  // namespace

bool SliceTool::take(const InputEvent& event, const FieldViewports& place) {
    using Kind = InputEvent::Kind;
    const bool holds = slice_.held != SliceGrip::None;
    if (event.kind == Kind::Press && !holds) {
        if (!slice_.open || event.code != GLFW_MOUSE_BUTTON_LEFT || event.mods != 0) return false;
        const auto hit = hit_slice(slice_.line, run_.session(), place, {event.x, event.y}, theme_.scale);
        if (!hit) return false;
        slice_.held = hit->grip;
        lane_ = hit->lane;
        began_ = fraction(place, *place.of(lane_), event.x, event.y);
        before_ = slice_.line;
        return true;
    }
    if (event.kind == Kind::Release && holds && event.code == GLFW_MOUSE_BUTTON_LEFT) {
        slice_.held = SliceGrip::None;
        return true;
    }
    if (event.kind != Kind::Move || !holds) return false;
    const FieldTile* tile = place.of(lane_);
    if (tile == nullptr) return true;
    const glm::dvec2 shown = glm::dvec2(place.window.high) - glm::dvec2(place.window.low);
    const glm::dvec2 near = static_cast<double>(snap_reach * theme_.scale) * shown /
                            glm::dvec2(tile->rect.width, tile->rect.height);
    slice_.line = dragged(before_, slice_.held, fraction(place, *tile, event.x, event.y) - began_, near,
                          run_.session().lanes[lane_].grid());
    return true;
}

/// The brush's buttons and keys come first.
bool SliceTool::hover(const FieldViewports& place) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool could = slice_.open && !io.KeyShift && !io.KeyCtrl && !io.KeyAlt && !ImGui::IsAnyMouseDown();
    const glm::dvec2 pointer(static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
    const auto hit =
        could ? hit_slice(slice_.line, run_.session(), place, pointer, theme_.scale) : std::nullopt;
    slice_.under_pointer = hit ? hit->grip : SliceGrip::None;
    slice_.pointed_on_field = hit ? std::optional(hit->part) : std::nullopt;
    return slice_.grip() != SliceGrip::None;
}

const ToolEntry slice_tool{
    .key = "slice", .mouse = {}, .keys = {}, .make = [](const Services& s) -> std::unique_ptr<Tool> {
        return std::make_unique<SliceTool>(s.ui.theme, s.run, s.shared.of<Slice>());
    }};

}  // namespace whorl::app
