// A GLFW window with OpenGL 3.3 core and ImGui in it.
#pragma once

#include <imgui.h>

#include <memory>

#include "app/render/theme.h"
#include "app/window/input.h"
#include "app/window/window.h"

namespace whorl::app {

class GlfwWindow {
  public:
    /// @throws NoWindow
    explicit GlfwWindow(const WindowOptions& options);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    bool closing() const;
    void close();
    /// Takes the window off the screen.
    void hide();
    const Theme& theme() const { return theme_; }
    int framebuffer_width() const { return width_; }
    int framebuffer_height() const { return height_; }

    /// Waits until the system's next event, at most so long.
    void await_events(double seconds);
    /// Lets the system's events come in, follows size and content scale, and begins an ImGui frame.
    /// @return the input since the last frame
    const std::vector<InputEvent>& begin_frame();
    /// Draws ImGui's frame over what has been drawn, and shows all.
    void end_frame();

  private:
    class Glfw {
      public:
        Glfw();
        ~Glfw();
        Glfw(const Glfw&) = delete;
        Glfw& operator=(const Glfw&) = delete;
    };

    void open(int width, int height);
    double screen_scale() const;
    void limit_size();

    Glfw glfw_;
    GLFWwindow* window_ = nullptr;
    std::unique_ptr<Input> input_;
    Theme theme_;
    double forced_scale_;
    int width_ = 0, height_ = 0;
};

}  // namespace whorl::app
