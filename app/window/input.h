// Collects what mouse and keyboard do, from GLFW.
#pragma once

#include <vector>

#include "app/ui/input_event.h"

struct GLFWwindow;

namespace whorl::app {

/// Collects GLFW's callbacks between two frames: ImGui looks once a frame, and would miss most positions of a
/// quick stroke and keys tapped within a frame.
class Input {
  public:
    /// Installs the callbacks; ImGui's must be installed after, it then calls these.
    explicit Input(GLFWwindow* window);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    /// The events since the last call.
    const std::vector<InputEvent>& take();

  private:
    void install();

    GLFWwindow* window_;
    bool repeating_ = false;  ///< the last key event was a repetition
    double x_ = 0, y_ = 0;
    std::vector<InputEvent> collected_, taken_;
};

}  // namespace whorl::app
