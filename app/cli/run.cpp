// `whorl run`: a scene without a window.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/plot/ticks.h"
#include "app/scenes/presets.h"
#include "core/io/series.h"
#include "core/scene/error.h"

namespace whorl::app {
namespace {

void write_row(Series& csv, const Measures& m) {
    const double row[] = {
        static_cast<double>(m.step), m.time,        m.density_percent, m.kinetic_energy, m.enstrophy,
        m.divergence_after,          m.min_density, m.max_density};
    csv.row(row);
}

/// Medians over the steps of a run, row by row.
class Timing {
  public:
    explicit Timing(int steps) { steps_.reserve(static_cast<std::size_t>(steps)); }
    void add(const Measures& m) { steps_.push_back({m.ms, m.pressure}); }
    void write(const std::string& file) const {
        Series series(file, "phase,median_ms");
        series.row("forces", median([](const Step& s) { return s.ms.forces; }));
        series.row("projection", median([](const Step& s) { return s.ms.projection; }));
        series.row("advection", median([](const Step& s) { return s.ms.advection; }));
        series.row("total", median([](const Step& s) { return s.ms.total; }));
        // Within the projection; the last two are no times.
        series.row("pressure_setup", median([](const Step& s) { return s.pressure.setup_ms; }));
        series.row("pressure_solve", median([](const Step& s) { return s.pressure.solve_ms; }));
        series.row("pressure_iterations", median([](const Step& s) { return s.pressure.iterations; }));
        series.row("pressure_residual", median([](const Step& s) { return s.pressure.residual; }));
        series.finish();
    }

  private:
    struct Step {
        PhaseTimes ms;
        SolveReport pressure;
    };
    template <class Figure>
    double median(Figure&& figure) const {
        if (steps_.empty()) return 0;
        std::vector<double> values;
        values.reserve(steps_.size());
        for (const Step& step : steps_) values.push_back(figure(step));
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    }
    std::vector<Step> steps_;
};

}  // namespace

int run_scene(const RunArguments& arguments) {
    Scene scene = find_run(arguments.scene).setup.scene;
    apply_settings(scene, arguments.set);
    const int steps = arguments.steps.value_or(scene.steps);
    if (steps < 0) throw InputError("--steps = " + std::to_string(steps) + " is out of range: 0 or more");
    PictureOutput picture(arguments);

    Pool pool(arguments.threads);
    Lane lane(scene, pool);
    std::optional<Series> csv;
    if (!arguments.csv.empty()) {
        csv.emplace(arguments.csv,
                    "step,time,density_percent,kinetic_energy,enstrophy,max_divergence,min,max");
    }
    Timing timing(steps);
    {
        Progress progress(arguments.scene, steps);
        for (int step = 0; step < steps; ++step) {
            if (!lane.step()) throw NotFinite(*lane.failure());
            const Measures& m = lane.simulation().measures();
            timing.add(m);
            if (csv) write_row(*csv, m);
            progress.at(step + 1);
        }
    }
    if (csv) csv->finish();
    if (!arguments.timing.empty()) timing.write(arguments.timing);
    picture.write(lane, pool);
    if (arguments.csv.empty() && arguments.timing.empty()) {
        const Measures& m = lane.simulation().measures();
        const std::string smoke = std::isfinite(m.density_percent)
                                      ? "density " + figure(m.density_percent) + " % of what was put in"
                                      : "no smoke";
        std::printf("%s: step %ld, t = %g, %s, kinetic energy %.4g, enstrophy %.4g\n",
                    arguments.scene.c_str(), m.step, m.time, smoke.c_str(), m.kinetic_energy, m.enstrophy);
    }
    return 0;
}

}  // namespace whorl::app
