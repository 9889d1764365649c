// What mouse and keyboard do, every event of it, in order.
#pragma once

#include <string>

namespace whorl::app {

/// One event. Positions are framebuffer pixels from the top left.
struct InputEvent {
    enum class Kind { Move, Press, Release, Wheel, Character, Key, KeyUp, Drop };

    Kind kind;
    double x = 0, y = 0;    ///< of the pointer
    double turn = 0;        ///< of the wheel, notches
    int code = 0;           ///< mouse button, Unicode character or GLFW key
    int mods = 0;           ///< GLFW modifier bits
    bool repeated = false;  ///< a key that is held
    std::string path{};     ///< of a file that was dropped
};

}  // namespace whorl::app
