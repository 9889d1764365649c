// What a whole step costs: the plume by scheme and resolution, phase by phase, and every experiment.
#include <benchmark/benchmark.h>

#include <map>

#include "core/scene/parameters.h"
#include "core/simulation/simulation.h"

namespace whorl {
namespace {

/// The thesis' abbreviations [T table 5.3].
struct NamedSet {
    const char* name;
    const char* advector;
    const char* interpolation;
};
constexpr NamedSet sets[] = {{"SL-LIN", "semi-lagrangian", "linear"},
                             {"MC-LIN", "maccormack", "linear"},
                             {"SL-FC", "semi-lagrangian", "fritsch-carlson"},
                             {"MC-FC", "maccormack", "fritsch-carlson"},
                             {"ASLAM", "aslam", "linear"}};

/// Steps after which a plume has found its flow.
constexpr int settling_steps = 60;

void step_scene(benchmark::State& state, const Scene& scene, int threads) {
    Pool pool(threads);
    Simulation simulation(scene, pool);
    for (int k = 0; k < settling_steps; ++k) simulation.step();
    std::map<std::string_view, double> sum;
    for (auto _ : state) {
        simulation.step();
        for (const auto& [key, share] : simulation.measures().phases) sum[key] += share.ms;
    }
    const double n = static_cast<double>(state.iterations());
    for (const auto& [key, ms] : sum) state.counters[std::string(key) + "_ms"] = ms / n;
    const Grid grid = scene.grid();
    state.counters["cells/s"] = benchmark::Counter(n * grid.nx * grid.ny, benchmark::Counter::kIsRate);
}

void register_all() {
    for (const NamedSet& set : sets) {
        for (const int resolution : {128, 256, 512}) {
            for (const int threads : {1, 2}) {
                Scene scene = scene_of(experiment("plume"));
                set_parameter(scene, "advector", set.advector);
                set_parameter(scene, "interpolation", set.interpolation);
                scene.resolution = resolution;
                const std::string name = std::string("plume/") + set.name + "/" + std::to_string(resolution) +
                                         "/threads:" + std::to_string(threads);
                benchmark::RegisterBenchmark(name.c_str(), step_scene, scene, threads)
                    ->Unit(benchmark::kMillisecond)
                    ->UseRealTime();
            }
        }
    }
    for (const Experiment& e : experiments()) {
        const std::string name = "experiment/" + std::string(e.info.key);
        benchmark::RegisterBenchmark(name.c_str(), step_scene, scene_of(e), 2)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    }
}

const bool registered = (register_all(), true);

}  // namespace
}  // namespace whorl
