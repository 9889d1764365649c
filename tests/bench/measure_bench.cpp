// What measuring costs: the flow's sums, which a step takes three times, its spectrum, and averaging down.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/measure/average.h"
#include "core/measure/flow_sums.h"
#include "core/measure/spectrum.h"
#include "core/scene/state.h"

namespace whorl {
namespace {

State waves(int resolution, const Sides& sides) {
    Scene scene;
    scene.resolution = resolution;
    scene.sides = sides;
    State state = make_state(scene);
    for (Field* field : {&state.velocity.u, &state.velocity.v, &state.density()})
        write_samples(*field, state.grid(), [](WorldPoint at) { return std::sin(at.x) * std::cos(at.y); });
    state.boundary.enforce(state.velocity);
    state.fill_ghosts();
    return state;
}

void flow_sums(benchmark::State& state) {
    const State flow = waves(static_cast<int>(state.range(0)), sides::box);
    Pool pool(static_cast<int>(state.range(1)));
    FlowReducer meter;
    for (auto _ : state) benchmark::DoNotOptimize(meter.measure(flow.velocity, flow.boundary, pool));
}
BENCHMARK(flow_sums)->ArgsProduct({{128, 256, 512}, {1, 2}})->UseRealTime()->Unit(benchmark::kMicrosecond);

void spectrum(benchmark::State& state, const Sides& sides) {
    const State flow = waves(static_cast<int>(state.range(0)), sides);
    Spectrum spectrum;
    for (auto _ : state) spectrum.compute(flow.velocity, flow.boundary);
}
BENCHMARK_CAPTURE(spectrum, box, sides::box)
    ->Arg(128)
    ->Arg(250)
    ->Arg(256)
    ->Arg(257)
    ->Arg(512)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(spectrum, periodic, sides::periodic)
    ->Arg(128)
    ->Arg(256)
    ->Arg(512)
    ->Unit(benchmark::kMillisecond);

void average(benchmark::State& state) {
    const State fine = waves(static_cast<int>(state.range(0)), sides::box);
    Scene scene;
    scene.resolution = static_cast<int>(state.range(1));
    Field out = boundary_of(scene).field(Site::Centre);
    Averager averager;
    for (auto _ : state) averager.average(fine.density(), fine.boundary, scene.grid(), out);
}
BENCHMARK(average)->Args({256, 128})->Args({1024, 128})->Args({512, 300})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace whorl
