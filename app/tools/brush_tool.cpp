#include "app/tools/brush_tool.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "app/tools/list.h"
#include "core/sources/obstacle_stroke.h"
#include "core/sources/smoke_stroke.h"

namespace whorl::app {
namespace {

constexpr KeyHelp mouse[] = {{"Drag", "inject smoke and heat, and pull the fluid along"},
                             {"Right-drag", "push the fluid only"},
                             {"Shift-drag", "paint an obstacle"},
                             {"Ctrl-drag", "erase obstacles"},
                             {"Wheel", "radius of the brush"}};

constexpr double fastest = 40;  // length/time that a stroke may give the fluid; a flick is far beyond

double length(WorldPoint a, WorldPoint b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

}  // namespace

bool BrushTool::take(const InputEvent& event, const FieldViewports& place) {
    using Kind = InputEvent::Kind;
    if (event.kind == Kind::Press && mode_ == Mode::None) {
        const FieldTile* tile = place.at(event.x, event.y);
        if (tile == nullptr) return false;
        if (event.code == GLFW_MOUSE_BUTTON_RIGHT) {
            mode_ = Mode::Push;
        } else if (event.code == GLFW_MOUSE_BUTTON_LEFT) {
            mode_ = (event.mods & GLFW_MOD_SHIFT) != 0     ? Mode::Paint
                    : (event.mods & GLFW_MOD_CONTROL) != 0 ? Mode::Erase
                                                           : Mode::Smoke;
        } else {
            return false;
        }
        button_ = event.code;
        fresh_ = true;
        ended_ = false;
        lane_ = tile->lane;
        path_.assign(1, place.world(*tile, event.x, event.y));
    } else if (event.kind == Kind::Move && mode_ != Mode::None && !ended_) {
        const auto tile = std::find_if(place.tiles.begin(), place.tiles.end(),
                                       [&](const FieldTile& t) { return t.lane == lane_; });
        if (tile != place.tiles.end()) path_.push_back(place.world(*tile, event.x, event.y));
    } else if (event.kind == Kind::Release && mode_ != Mode::None && event.code == button_) {
        ended_ = true;
    } else if (event.kind == Kind::Wheel && place.at(event.x, event.y) != nullptr) {
        run_.set(parameter("brush.radius"), wheel_radius(run_.scene().brush.radius, event.turn));
    } else {
        return false;
    }
    return true;
}

void BrushTool::end_frame() {
    if (mode_ == Mode::None) return;
    const bool obstacle = mode_ == Mode::Paint || mode_ == Mode::Erase;
    obstacle ? send_obstacle() : send_smoke();
    path_.erase(path_.begin(), path_.end() - 1);
    fresh_ = false;
    if (ended_) mode_ = Mode::None;
}

void BrushTool::send_smoke() {
    const Snapshot& s = run_.snapshot();
    const Brush& brush = run_.scene().brush;
    const double elapsed = fresh_ ? s.scene.dt : std::max(s.measures.time - last_time_, s.scene.dt);
    last_time_ = s.measures.time;
    SmokeStroke stroke{.along = {},
                       .radius = brush.radius,
                       .amounts = brush.amounts,
                       .push = brush.push,
                       .smoke = mode_ == Mode::Smoke};
    if (path_.size() == 1) {
        if (!stroke.smoke || !(fresh_ || run_.playing())) return;
        stroke.along = {path_[0].x, path_[0].y, path_[0].x, path_[0].y};
        run_.push(stroke);
        return;
    }
    double whole = 0;
    for (std::size_t k = 1; k < path_.size(); ++k) whole += length(path_[k - 1], path_[k]);
    const double speed = std::min(whole / elapsed, fastest);
    for (std::size_t k = 1; k < path_.size(); ++k) {
        const WorldPoint a = path_[k - 1];
        const WorldPoint b = path_[k];
        const double far = length(a, b);
        stroke.along = {a.x, a.y, b.x, b.y};
        stroke.velocity_x = far > 0 ? (b.x - a.x) / far * speed : 0;
        stroke.velocity_y = far > 0 ? (b.y - a.y) / far * speed : 0;
        run_.push(stroke);
    }
}

void BrushTool::send_obstacle() {
    if (path_.size() == 1 && !fresh_) return;
    ObstacleStroke stroke{.along = {}, .radius = run_.scene().brush.radius, .solid = mode_ == Mode::Paint};
    for (std::size_t k = path_.size() == 1 ? 0 : 1; k < path_.size(); ++k) {
        const WorldPoint a = path_[k > 0 ? k - 1 : 0];
        stroke.along = {a.x, a.y, path_[k].x, path_[k].y};
        run_.push(stroke);
    }
}

double wheel_radius(double radius, double notches) {
    const Parameter& p = parameter("brush.radius");
    const double wanted = std::clamp(radius * std::pow(1.1, notches), p.slider_min, p.slider_max);
    return std::clamp(std::round(wanted * 100) / 100, p.min, p.max);
}

const ToolEntry brush_tool{
    .key = "brush", .mouse = mouse, .keys = {}, .make = [](const Services& s) -> std::unique_ptr<Tool> {
        return std::make_unique<BrushTool>(s.run);
    }};

}  // namespace whorl::app
