// `whorl run`: a scene without a window.
#include <algorithm>
#include <cstdio>
#include <optional>
#include <vector>

#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
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

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void write_timing(const std::string& file, const std::vector<PhaseTimes>& times) {
    constexpr std::pair<const char*, double PhaseTimes::*> phases[] = {
        {"forces", &PhaseTimes::forces},
        {"projection", &PhaseTimes::projection},
        {"advection", &PhaseTimes::advection},
        {"total", &PhaseTimes::total}};
    Series series(file, "phase,median_ms");
    for (const auto& [name, member] : phases) {
        std::vector<double> values;
        for (const PhaseTimes& t : times) values.push_back(t.*member);
        series.row(name, median(std::move(values)));
    }
    series.finish();
}

}  // namespace

int run_scene(const RunArguments& arguments) {
    Scene scene = find_scene(arguments.scene);
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
    std::vector<PhaseTimes> times;
    times.reserve(static_cast<std::size_t>(steps));
    {
        Progress progress(arguments.scene, steps);
        for (int step = 0; step < steps; ++step) {
            if (!lane.step()) throw NotFinite(*lane.failure());
            const Measures& m = lane.simulation().measures();
            times.push_back(m.ms);
            if (csv) write_row(*csv, m);
            progress.at(step + 1);
        }
    }
    if (csv) csv->finish();
    if (!arguments.timing.empty()) write_timing(arguments.timing, times);
    picture.write(lane, pool);
    if (arguments.csv.empty() && arguments.timing.empty()) {
        const Measures& m = lane.simulation().measures();
        std::printf(
            "%s: step %ld, t = %g, density %.2f %% of what was put in, kinetic energy %.4g, enstrophy %.4g\n",
            arguments.scene.c_str(), m.step, m.time, m.density_percent, m.kinetic_energy, m.enstrophy);
    }
    return 0;
}

}  // namespace whorl::app
