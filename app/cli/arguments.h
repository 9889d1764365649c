// What the command line asks for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace whorl::app {

/// `whorl [PRESET|FILE]`
struct WindowArguments {
    std::string scene = "plume";
    std::vector<std::string> set;
    std::string lanes;  ///< comparison or file; empty for the scene's own
    int threads = 0;    ///< 0 takes one a core
    std::string size;
    std::optional<bool> tour;  ///< else if it has not been taken yet
    std::string trace;
    double content_scale = 0;
};

/// How to draw.
struct DrawArguments {
    std::string view = "density", map, range;
    int width = 0;    ///< 0 takes what suits the number of fields
    float scale = 0;  ///< 0 takes what suits the width
    bool light = false, crisp = false;
    bool difference = false;  ///< of each lane from the reference lane
    bool operator==(const DrawArguments&) const = default;
};

/// `whorl run PRESET|FILE`, and `whorl experiment NAME`
struct RunArguments {
    std::string scene;
    std::vector<std::string> set;
    std::string lanes;  ///< comparison or file; empty for the scene's own
    std::optional<int> steps;
    std::vector<int> at;
    std::string csv, picture, timing;  ///< files; empty for none, `-` for standard output
    std::string measures;              ///< columns of csv, as "a,b"; empty for the usual ones
    std::string save;                  ///< file that the run is written to
    std::string animate;               ///< film; empty for none
    int every = 2, fps = 30;           ///< steps a frame, frames a second
    bool digest = false;
    bool limiters = false;  ///< rows count the nodes that limiters change
    DrawArguments draw;
    int threads = 0;
};

/// `whorl compare PRESET|FILE`
struct CompareArguments {
    std::string scene;
    std::vector<std::string> set;
    std::string lanes;
    std::vector<int> at;
    std::string out, csv, measures;
    DrawArguments draw;
    int threads = 0;
};

/// `whorl explain PRESET|FILE`
struct ExplainArguments {
    std::string scene;
    std::vector<std::string> set;
    std::string lanes;
    int at = 1;
    std::vector<int> cell;  ///< i, j
    std::string field = "density";
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

/// `whorl lesson [KEY|FILE]`
struct LessonArguments {
    std::string lesson;    ///< empty for all
    bool check = false;    ///< its claims
    std::string pictures;  ///< folder; empty for none
    int threads = 0;
};

struct ExperimentArguments : RunArguments {};

/// What was asked for, or the exit code where all has been said (`--help`, a wrong option).
using Arguments = std::variant<int, WindowArguments, RunArguments, ExperimentArguments, CompareArguments,
                               ExplainArguments, ConvergeArguments, ListArguments, LessonArguments>;

/// @throws InputError for a list that is not one
Arguments parse_arguments(int argc, char** argv);

}  // namespace whorl::app
