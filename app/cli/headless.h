// What runs without a window share: the scene as asked for, and its last step as a picture.
#pragma once

#include "app/cli/arguments.h"
#include "core/session/lane.h"

namespace whorl::app {

/// Sets the parameters given by --set, and checks that the choices go together.  @throws InputError
void apply_settings(Scene& scene, const std::vector<std::string>& settings);

/// Checks that all outputs can be written and that view and map exist, before a long run.
/// @throws InputError, std::runtime_error
void check_outputs(const RunArguments& arguments);

/// Draws the lane's present step as --picture, --view and --map ask.
/// @throws InputError, std::runtime_error
void write_picture(const Lane& lane, Pool& pool, const RunArguments& arguments);

/// Says on standard error that something was written, unless the run's rows go to standard output.
void say_written(const std::string& what, const std::string& file);

}  // namespace whorl::app
