// What the command line asks for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace whorl::app {

/// `whorl [PRESET|FILE.toml]`
struct WindowArguments {
    std::string scene = "plume";
    std::vector<std::string> set;
    int threads = 0;  ///< 0 takes one a core
    std::string size;
    std::string trace;
    double content_scale = 0;
};

/// `whorl run PRESET|FILE.toml`, and `whorl experiment NAME`
struct RunArguments {
    std::string scene;
    std::vector<std::string> set;
    std::optional<int> steps;
    std::vector<int> at;
    std::string csv, picture, timing;  ///< files; empty for none, `-` for standard output
    std::string view = "density", map, range;
    int width = 900;
    bool light = false, crisp = false;
    int threads = 0;
};

/// `whorl converge EXPERIMENT`
struct ConvergeArguments {
    std::string experiment;
    std::vector<std::string> set;
    std::vector<int> resolutions;
    int threads = 0;
};

/// `whorl list [WHAT]`
struct ListArguments {
    std::string what;
};

struct ExperimentArguments : RunArguments {};

/// What was asked for, or the exit code where all has been said (`--help`, a wrong option).
using Arguments =
    std::variant<int, WindowArguments, RunArguments, ExperimentArguments, ConvergeArguments, ListArguments>;

/// @throws InputError for a list that is not one
Arguments parse_arguments(int argc, char** argv);

}  // namespace whorl::app
