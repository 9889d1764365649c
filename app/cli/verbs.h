// The verbs of the command line; each returns the program's exit code.
#pragma once

#include "app/cli/arguments.h"

namespace whorl::app {

/// Runs a scene without a window.
/// @throws InputError, NotFinite, std::runtime_error if a file cannot be written
int run_scene(const RunArguments& arguments);

/// Runs an experiment and reports its errors.  @throws as run_scene
int run_experiment(const ExperimentArguments& arguments);

/// Draws a contact sheet of several lanes at several steps.  @throws as run_scene
int run_compare(const CompareArguments& arguments);

/// Prints how a step made the value of one node, and at how many nodes limiters acted.  @throws as run_scene
int run_explain(const ExplainArguments& arguments);

/// Prints errors and rates of an experiment on ever finer grids.  @throws as run_scene
int run_converge(const ConvergeArguments& arguments);

/// Lists lessons, prints one, or runs its steps and checks what they claim.
/// @throws InputError, NoOpenGl, std::runtime_error if a picture cannot be written
int run_lesson(const LessonArguments& arguments);

/// Prints what there is to choose from.  @throws InputError
int run_list(const ListArguments& arguments);

}  // namespace whorl::app
