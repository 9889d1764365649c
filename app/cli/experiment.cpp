// `whorl experiment`: a test with a known answer, and its errors.
#include <algorithm>
#include <optional>

#include "app/cli/columns.h"
#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/experiments/experiment.h"
#include "core/io/series.h"

namespace whorl::app {

int run_experiment(const ExperimentArguments& arguments) {
    Scene scene = experiment_scene(arguments.scene);
    apply_settings(scene, arguments.set);
    const std::vector<int>& at = arguments.at;
    if (!at.empty() && arguments.steps) throw InputError("--at and --steps both say where to end; give one");
    const int steps =
        !at.empty() ? *std::max_element(at.begin(), at.end()) : arguments.steps.value_or(scene.steps);
    if (steps < 0 || std::any_of(at.begin(), at.end(), [](int step) { return step < 0; })) {
        throw InputError("a step is a whole number, 0 or more");
    }
    Columns columns(&Tables::experiment, arguments.measures);
    if (arguments.measures.empty()) columns.errors_first();
    if (!arguments.picture.empty()) check_picture("--picture", arguments.picture);
    std::optional<Drawing> drawing;
    if (!arguments.picture.empty()) drawing.emplace(arguments.draw);

    Pool pool(arguments.threads);
    Session session({.setup = {.scene = scene}}, pool);
    session.ask(columns.all());
    std::optional<Series> csv;
    // Rows are what an experiment is run for: they go to standard output unless something else was asked for.
    const std::string file = arguments.csv.empty() && arguments.picture.empty() ? "-" : arguments.csv;
    if (!file.empty()) csv.emplace(file, columns.header());
    {
        Progress progress(arguments.scene, steps);
        for (int step = 0; step <= steps; ++step) {
            if (step > 0) session.step();
            if (!session.running()) throw NotFinite(*session.lane(0).failure());
            const bool wanted = at.empty() ? step > 0 : std::find(at.begin(), at.end(), step) != at.end();
            if (csv && wanted) csv->row(columns.row(step, session.measures(0)));
            progress.at(step);
        }
    }
    if (csv) csv->finish();
    if (drawing) {
        SessionSnapshot last;
        take_shown(session, view(arguments.draw.view), last, pool, last);
        write_picture(arguments.picture, drawing->draw({&last, 1}), session.recording());
    }
    return 0;
}

}  // namespace whorl::app
