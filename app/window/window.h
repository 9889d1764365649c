// The window: opens, runs until it is closed.
#pragma once

#include <optional>
#include <string>

#include "app/render/no_opengl.h"
#include "core/session/recording.h"

namespace whorl::app {

struct WindowOptions {
    Recording recording;
    std::string name = "plume";  ///< preset, experiment or file it came from
    int threads = 0;             ///< of the solver; 0 takes one a core
    int width = 0, height = 0;   ///< of the window, pixels; 0 takes what suits the screen
    double content_scale = 0;    ///< framebuffer pixels to a point; 0 asks the screen
    std::optional<bool> tour;    ///< whether to begin with it; else if it has not been taken yet
    std::string lesson;          ///< file that is opened over it; empty for none
    std::string trace;           ///< file of the EventLog; empty for none
};

/// There is no display, or it gives no OpenGL 3.3.
struct NoWindow : NoOpenGl {
    using NoOpenGl::NoOpenGl;
};

/// Shows the sandbox until it is closed.
/// @return the program's exit code
/// @throws NoWindow with one line that says what is missing
int run_window(const WindowOptions& options);

}  // namespace whorl::app
