// `whorl converge`: errors and rates under refinement, as the thesis' table 5.2 prints them.
#include <cmath>
#include <cstdio>

#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

void check_nested(const std::vector<int>& resolutions) {
    if (resolutions.size() < 2) throw InputError("--resolutions needs two or more, as 40,80,160");
    for (std::size_t k = 1; k < resolutions.size(); ++k) {
        const int coarse = resolutions[k - 1];
        const int fine = resolutions[k];
        if (coarse < 1 || fine <= coarse || fine % coarse != 0) {
            throw InputError("--resolutions do not nest: " + std::to_string(fine) + " is not a multiple of " +
                             std::to_string(coarse) + "; give them rising, as 40,80,160");
        }
    }
}

Errors errors_at(const ConvergeArguments& arguments, int resolution, Pool& pool) {
    Scene scene = experiment_scene(arguments.experiment);
    std::vector<std::string> settings = arguments.set;
    settings.push_back("resolution=" + std::to_string(resolution));
    apply_settings(scene, settings);
    Lane lane(scene, pool);
    Progress progress(arguments.experiment + " at " + std::to_string(resolution), scene.steps);
    for (int step = 1; step <= scene.steps; ++step) {
        if (!lane.step()) throw NotFinite(*lane.failure());
        progress.at(step);
    }
    return lane.simulation().measures().errors;
}

/// Before a long run: whether there will be anything to compare with at its end.
void check_exact(const ConvergeArguments& arguments) {
    Scene scene = experiment_scene(arguments.experiment);
    const Experiment& e = experiment(scene.experiment);
    if (e.exact == nullptr) {
        throw InputError(arguments.experiment + " has no exact solution, so there is no error to converge");
    }
    apply_settings(scene, arguments.set);
    Field exact = Boundary(scene.grid(), scene.sides).field(Site::Centre);
    if (!e.exact(scene.steps * scene.dt, scene.dt, scene.grid(), exact)) {
        throw InputError("the exact solution of " + arguments.experiment + " is not known at step " +
                         std::to_string(scene.steps) + "; it is known " + std::string(e.known));
    }
}

}  // namespace

int run_converge(const ConvergeArguments& arguments) {
    check_exact(arguments);
    check_nested(arguments.resolutions);
    for (const std::string& setting : arguments.set) {
        if (setting.starts_with("resolution="))
            throw InputError("--resolutions sets the resolution, not --set");
    }
    Pool pool(arguments.threads);
    std::printf("%-8s  %-10s  %-5s  %-10s  %-5s  %-10s  %-5s\n", "h", "L1", "rate", "L2", "rate", "Linf",
                "rate");
    Errors last{};
    int coarse = 0;
    for (const int resolution : arguments.resolutions) {
        const Errors e = errors_at(arguments, resolution, pool);
        const double h = experiment_scene(arguments.experiment).width / resolution;
        const auto rate = [&](double before, double now) {
            char text[16] = "-";
            if (coarse > 0) {
                const double refined = static_cast<double>(resolution) / coarse;
                std::snprintf(text, sizeof text, "%.3f", std::log(before / now) / std::log(refined));
            }
            return std::string(text);
        };
        std::printf("%-8.5g  %-10.4g  %-5s  %-10.4g  %-5s  %-10.4g  %-5s\n", h, e.L1,
                    rate(last.L1, e.L1).c_str(), e.L2, rate(last.L2, e.L2).c_str(), e.Linf,
                    rate(last.Linf, e.Linf).c_str());
        std::fflush(stdout);
        last = e;
        coarse = resolution;
    }
    return 0;
}

}  // namespace whorl::app
