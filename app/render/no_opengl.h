// What is thrown where there is nothing to draw with.
#pragma once

#include <stdexcept>

namespace whorl::app {

/// There is no display, or no OpenGL 3.3; one line says what is missing.
struct NoOpenGl : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace whorl::app
