// What the program's exit codes mean.
#pragma once

namespace whorl::app {

inline constexpr int exit_failed = 1;     ///< the run broke off, or a file could not be written
inline constexpr int exit_bad_input = 2;  ///< the arguments or a scene file are wrong
inline constexpr int exit_no_opengl = 3;  ///< no display, or no OpenGL 3.3

}  // namespace whorl::app
