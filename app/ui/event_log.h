// What the window does, as lines in a file that tests and measurements read.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "app/ui/control_rects.h"
#include "app/ui/frame_log.h"
#include "core/session/snapshot.h"

namespace whorl::app {

/// Writes a JSON object a line: `{"event":"frame",…}` ten times a second, `{"event":"control","key":…,"x":…,
/// "y":…}` where a control lies (its middle, pixels) whenever that changes, and other events as they come.
/// Without a path nothing is written, but rectangles are known all the same.
class EventLog {
  public:
    /// @throws std::runtime_error if the file cannot be opened
    explicit EventLog(const std::string& path);
    ~EventLog();
    EventLog(const EventLog&) = delete;
    EventLog& operator=(const EventLog&) = delete;

    /// Call right after an ImGui item that a test may want to click.
    void control(std::string_view key);
    void rect(std::string_view key, float x, float y, float width, float height);
    const ControlRects& rects() const { return rects_; }
    void event(std::string_view name, std::string_view text);
    void frame(const FrameLog& frames, double steps_per_second, bool playing, const SessionSnapshot& session,
               double now);

  private:
    std::FILE* file_ = nullptr;
    ControlRects rects_;
    double next_frame_ = 0;
};

}  // namespace whorl::app
