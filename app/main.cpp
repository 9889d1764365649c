// Arguments -> window or command line.
#include <iostream>

#include "app/cli/exit_code.h"
#include "app/cli/verbs.h"
#include "core/scene/error.h"

namespace {

using namespace whorl::app;

int act(const Arguments& arguments) {
    return std::visit(
        []<class A>(const A& a) {
            if constexpr (std::is_same_v<A, int>) {
                return a;
            } else if constexpr (std::is_same_v<A, RunArguments>) {
                return run_scene(a);
            } else if constexpr (std::is_same_v<A, ExperimentArguments>) {
                return run_experiment(a);
            } else if constexpr (std::is_same_v<A, ConvergeArguments>) {
                return run_converge(a);
            } else if constexpr (std::is_same_v<A, ListArguments>) {
                return run_list(a);
            } else {
                return 0;
            }
        },
        arguments);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return act(parse_arguments(argc, argv));
    } catch (const whorl::InputError& e) {
        std::cerr << "whorl: " << e.what() << '\n';
        return exit_bad_input;
    } catch (const std::exception& e) {
        std::cerr << "whorl: " << e.what() << '\n';
        return exit_failed;
    }
}
