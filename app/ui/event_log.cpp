#include "app/ui/event_log.h"

#include <imgui.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "core/base/number.h"

namespace whorl::app {
namespace {

constexpr double period = 0.1;  // seconds between two frame lines

std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out + "\"";
}

/// JSON knows no NaN.
std::string number(double value) {
    if (!std::isfinite(value)) return "null";
    return significant(value, 6);
}

/// ∫ρ over the fluid.
double total_density(const Snapshot& s) {
    double sum = 0;
    for (int j = 0; j < s.grid().ny; ++j) {
        for (int i = 0; i < s.grid().nx; ++i) {
            const bool solid = s.solids()[static_cast<std::size_t>(j) * s.grid().nx + i] != 0;
            if (!solid) sum += static_cast<double>(s.density()(i, j));
        }
    }
    return sum * s.grid().cell();
}

/// `,"total_density_1":…` and so on for every lane.
std::string densities(const SessionSnapshot& session) {
    std::string line;
    for (std::size_t k = 0; k < session.lanes.size(); ++k)
        line += ",\"total_density_" + std::to_string(k + 1) + "\":" + number(total_density(session.lanes[k]));
    return line;
}

}  // namespace

EventLog::EventLog(const std::string& path) {
    if (path.empty()) return;
    file_ = std::fopen(path.c_str(), "w");
    if (file_ == nullptr) throw std::runtime_error(path + ": " + std::strerror(errno));
}

EventLog::~EventLog() {
    if (file_ != nullptr) std::fclose(file_);
}

void EventLog::control(std::string_view key) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    rect(key, low.x, low.y, size.x, size.y);
}

void EventLog::rect(std::string_view key, float x, float y, float width, float height) {
    const ControlRect rect{x, y, width, height};
    const ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = list.GetClipRectMin();
    const ImVec2 high = list.GetClipRectMax();
    const ControlRect seen = clipped(rect, low.x, low.y, high.x, high.y);
    if (!rects_.note(key, rect, seen, ImGui::GetFrameCount()) || file_ == nullptr) return;
    std::fprintf(file_, "{\"event\":\"control\",\"key\":%s,\"x\":%.0f,\"y\":%.0f,\"w\":%.0f,\"h\":%.0f}\n",
                 quoted(key).c_str(), static_cast<double>(x + 0.5f * width),
                 static_cast<double>(y + 0.5f * height), static_cast<double>(width),
                 static_cast<double>(height));
    std::fflush(file_);
}

void EventLog::event(std::string_view name, std::string_view text) {
    if (file_ == nullptr) return;
    std::fprintf(file_, "{\"event\":%s,\"text\":%s}\n", quoted(name).c_str(), quoted(text).c_str());
    std::fflush(file_);
}

void EventLog::frame(const FrameLog& frames, double steps_per_second, bool playing,
                     const SessionSnapshot& session, double now) {
    if (file_ == nullptr || now < next_frame_ || frames.frames() == 0) return;
    next_frame_ = now + period;
    const Snapshot& s = session.lanes.front();
    const Scene& scene = s.scene;
    std::fprintf(file_,
                 "{\"event\":\"frame\",\"fps\":%s,\"frame_ms\":%s,\"work_ms\":%s,\"steps_per_second\":%s,"
                 "\"playing\":%s,\"run\":%d,\"step\":%ld,\"advector\":%s,\"velocity_advector\":%s,"
                 "\"interpolation\":%s,\"zeta\":%d,\"nx\":%d,\"density_percent\":%s,\"total_density\":%s,"
                 "\"solids\":%ld,\"brush_radius\":%s,\"lanes\":%zu%s}\n",
                 number(frames.frames_per_second()).c_str(),
                 number(static_cast<double>(frames.intervals().back())).c_str(),
                 number(static_cast<double>(frames.work().back())).c_str(), number(steps_per_second).c_str(),
                 playing ? "true" : "false", session.run, session.step,
                 quoted(scene.scalars.advector.key()).c_str(), quoted(scene.velocity.advector.key()).c_str(),
                 quoted(scene.scalars.interpolation.key()).c_str(), scene.scalars.zeta, s.grid().nx,
                 number(s.measures.density_percent()).c_str(), number(total_density(s)).c_str(),
                 std::count(s.solids().begin(), s.solids().end(), 1), number(scene.brush.radius).c_str(),
                 session.lanes.size(), densities(session).c_str());
    std::fflush(file_);
}

}  // namespace whorl::app
