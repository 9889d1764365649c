// Milliseconds that advection takes: the schemes of the plume's table over resolutions and threads.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "core/advection/advection.h"
#include "core/experiments/experiment.h"
#include "core/scene/parameters.h"
#include "core/scene/state.h"

namespace whorl {
namespace {

struct Setup {
    const char* name;
    std::vector<std::string> settings;
};

const Setup setups[] = {
    {"SL-LIN", {"advector=semi-lagrangian", "interpolation=linear"}},
    {"SL-FC", {"advector=semi-lagrangian", "interpolation=fritsch-carlson"}},
    {"MC-LIN", {"advector=maccormack", "interpolation=linear"}},
    {"BFECC-LIN", {"advector=bfecc", "interpolation=linear"}},
    {"ASLAM-2", {"advector=aslam", "zeta=2"}},
    {"ASLAM-2-manhattan", {"advector=aslam", "zeta=2", "stencil=manhattan"}},
    {"ASLAM-4", {"advector=aslam", "zeta=4"}},
};

/// Sixteen eddies with a CFL number of `cfl`, and waves of smoke: as smooth as a plume, and nowhere still.
void stir(State& state, double cfl, double dt) {
    const Grid& grid = state.grid();
    const double k = 4 * std::numbers::pi / grid.width();
    const double speed = cfl * grid.h / dt;
    const auto write = [&](Field& field, auto value) {
        for (int j = 0; j < field.height(); ++j) {
            for (int i = 0; i < field.width(); ++i) {
                const WorldPoint at = world(field, grid, i, j);
                field(i, j) = static_cast<Real>(value(at.x * k, at.y * k));
            }
        }
    };
    write(state.velocity.u, [&](double x, double y) { return speed * std::sin(x) * std::cos(y); });
    write(state.velocity.v, [&](double x, double y) { return -speed * std::cos(x) * std::sin(y); });
    write(state.density(), [](double x, double y) { return 1 + std::sin(5 * x) * std::sin(3 * y); });
    write(state.temperature(), [](double x, double y) { return 5 + std::cos(4 * x) * std::sin(6 * y); });
    state.fill_ghosts();
}

/// All four fields, one step; the flow and the fields stay as they are.
void advection(benchmark::State& run, const Setup& setup) {
    flush_denormals();
    Scene scene = scene_of(experiment("plume"));
    for (const std::string& setting : setup.settings) set_parameter(scene, setting);
    set_parameter(scene, "resolution=" + std::to_string(run.range(0)));
    Pool pool(static_cast<int>(run.range(1)));
    State from = make_state(scene);
    State to = from;
    constexpr double cfl = 2;
    stir(from, cfl, scene.dt);
    Advection advection;
    advection.set({scene.scalars, scene.dimensions, scene.seed});
    const AdvectedField fields[] = {{&from.density(), &to.density()},
                                    {&from.temperature(), &to.temperature()},
                                    {&from.velocity.u, &to.velocity.u},
                                    {&from.velocity.v, &to.velocity.v}};
    for (auto _ : run) advection.advect(fields, {&from.velocity, &from.boundary, &pool, scene.dt});
    const double cells = static_cast<double>(run.range(0)) * static_cast<double>(run.range(0));
    run.counters["ns_per_cell"] = benchmark::Counter(
        cells * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    // At least: each field is read and written once, and the velocity read.
    constexpr double fields_moved = 4 * 2;
    run.SetBytesProcessed(static_cast<std::int64_t>(static_cast<double>(run.iterations()) * cells *
                                                    fields_moved * sizeof(Real)));
}

/// What the machine copies, for the roofline: bytes read and written, with each thread on its own half.
void copying(benchmark::State& run) {
    const std::size_t bytes = static_cast<std::size_t>(run.range(0)) << 10;
    std::vector<char> from(bytes, 1), to(bytes);
    for (auto _ : run) {
        std::memcpy(to.data(), from.data(), bytes);
        benchmark::ClobberMemory();
    }
    run.SetBytesProcessed(static_cast<std::int64_t>(run.iterations()) * static_cast<std::int64_t>(2 * bytes));
}

const bool registered = [] {
    for (const int kilobytes : {256, 4096, 131072}) {
        benchmark::RegisterBenchmark("copy", copying)->Arg(kilobytes)->Threads(2)->UseRealTime();
    }
    for (const Setup& setup : setups) {
        auto* bench =
            benchmark::RegisterBenchmark((std::string("advect/") + setup.name).c_str(), advection, setup);
        bench->ArgNames({"n", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
        for (const int threads : {1, 2}) {
            for (const int n : {128, 256, 512, 1024, 2048}) bench->Args({n, threads});
        }
    }
    return true;
}();

}  // namespace
}  // namespace whorl
