// Arguments -> window or command line.
#include <cstdio>
#include <iostream>

#include "app/cli/exit_code.h"
#include "app/cli/headless.h"
#include "app/cli/verbs.h"
#include "app/lessons/lesson.h"
#include "app/render/no_opengl.h"
#include "app/scenes/files.h"
#include "app/window/window.h"
#include "core/base/error.h"
#include "core/io/whole_file.h"

namespace {

using namespace whorl::app;

/// @throws InputError for what is no size, or none that a window has
void read_size(const std::string& text, int& width, int& height) {
    constexpr int least_width = 320, least_height = 240, most = 8192;
    char beyond = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &beyond) != 2 || width < least_width ||
        height < least_height || width > most || height > most)
        throw whorl::InputError("--size " + text +
                                ": give WIDTHxHEIGHT from 320x240 to 8192x8192, such as 1600x1000");
}

int open_window(const WindowArguments& a) {
    WindowOptions options;
    if (names_file(a.scene) && is_lesson(run_text(a.scene))) {
        find_lesson(a.scene);  // says what is wrong with it before a window opens
        options.lesson = a.scene;
        options.recording = recording_for(options.name, a.lanes, a.set);
    } else {
        options.recording = recording_for(a.scene, a.lanes, a.set);
        options.name = a.scene;
    }
    options.threads = a.threads;
    options.content_scale = a.content_scale;
    options.tour = a.tour;
    options.trace = a.trace;
    if (!a.size.empty()) read_size(a.size, options.width, options.height);
    return run_window(options);
}

int act(const Arguments& arguments) {
    return std::visit(
        []<class A>(const A& a) {
            if constexpr (std::is_same_v<A, int>) {
                return a;
            } else if constexpr (std::is_same_v<A, RunArguments>) {
                return run_scene(a);
            } else if constexpr (std::is_same_v<A, ExperimentArguments>) {
                return run_experiment(a);
            } else if constexpr (std::is_same_v<A, CompareArguments>) {
                return run_compare(a);
            } else if constexpr (std::is_same_v<A, ExplainArguments>) {
                return run_explain(a);
            } else if constexpr (std::is_same_v<A, ConvergeArguments>) {
                return run_converge(a);
            } else if constexpr (std::is_same_v<A, ListArguments>) {
                return run_list(a);
            } else if constexpr (std::is_same_v<A, LessonArguments>) {
                return run_lesson(a);
            } else {
                return open_window(a);
            }
        },
        arguments);
}

}  // namespace

int main(int argc, char** argv) {
    whorl::take_unfinished_files_along();
    try {
        const int code = act(parse_arguments(argc, argv));
        if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
        std::cerr << "whorl: standard output takes no more\n";
        return exit_failed;
    } catch (const whorl::InputError& e) {
        std::cerr << "whorl: " << e.what() << '\n';
        return exit_bad_input;
    } catch (const NoOpenGl& e) {
        std::cerr << "whorl: " << e.what() << '\n';
        return exit_no_opengl;
    } catch (const std::exception& e) {
        std::cerr << "whorl: " << e.what() << '\n';
        return exit_failed;
    }
}
