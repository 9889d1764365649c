// What mouse and keyboard do, every event of it, in order.
#pragma once

#include <string>
#include <vector>

struct GLFWwindow;

namespace whorl::app {

/// One event. Positions are framebuffer pixels from the top left.
struct InputEvent {
    enum class Kind { Move, Press, Release, Wheel, Character, Key, KeyUp, Drop };

    Kind kind;
    double x = 0, y = 0;    ///< of the pointer; of the wheel its turn
    int code = 0;           ///< mouse button, Unicode character or GLFW key
    int mods = 0;           ///< GLFW modifier bits
    bool repeated = false;  ///< a key that is held
    std::string path{};     ///< of a file that was dropped
};

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
