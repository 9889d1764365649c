// The window's loop: a frame of the run, its input, and its pictures.
#pragma once

#include <memory>

#include "app/window/features.h"
#include "app/window/field_painter.h"
#include "app/window/file_service.h"
#include "app/window/frame_clock.h"
#include "app/window/glfw_window.h"

namespace whorl::app {

class MainWindow {
  public:
    /// @throws InputError if the scene's choices do not go together, std::runtime_error if the event log
    /// cannot
    ///         be written
    MainWindow(const WindowOptions& options, GlfwWindow& window);

    /// Waits for the next frame's time, and makes it.
    void frame();
    /// Whether something that was asked for is on its way to a file: frames bring it there.
    bool writes() const { return file_service_.writes(); }

  private:
    bool idle() const;
    void wait();
    void read_lesson();
    void draw();

    GlfwWindow& window_;
    EventLog log_;
    FrameClock clock_;
    int warm_up_ = 5;           ///< frames that are not measured yet
    std::uint64_t serial_ = 0;  ///< of the moment on screen
    bool was_idle_ = false;     ///< before the last frame
    double last_activity_ = 0;  ///< when something last came in or moved, seconds of the clock
    Notifications notifications_;
    std::unique_ptr<Player> player_;
    Features features_;
    FieldPainter painter_;
    FileService file_service_;
};

}  // namespace whorl::app
