// What the pressure solvers cost: one solve from a guess of 0, on as many threads as there are cores.
//   ./dev bench --benchmark_filter='^(solve|prepare|project)'
#include <benchmark/benchmark.h>

#include "core/pressure/ldlt.h"
#include "core/pressure/projection.h"
#include "tests/core/pressure/domains.h"

namespace {

using namespace whorl;

/// The default of scenes; and what its right side is: noise, the hardest to smooth for none of the solvers.
constexpr double tolerance = 1e-5;

struct Layout {
    const char* name;
    bool periodic;
    bool obstacles;
};
constexpr Layout layouts[] = {{"box", false, false}, {"periodic", true, false}, {"obstacles", false, true}};

Boundary domain(int n, const Layout& layout) {
    return test::domain(n, n, layout.periodic,
                        layout.obstacles ? test::discs(n, n) : std::vector<std::uint8_t>{});
}

void solve(benchmark::State& state, const PressureSolverEntry& entry, const Layout& layout, int n,
           int threads) {
    Pool pool(threads);
    flush_denormals();
    const Boundary boundary = domain(n, layout);
    const std::vector<double> b = test::random_right(boundary, 5, pool);
    const double enough = tolerance * test::largest(b);
    const auto solver = entry.create();
    solver->prepare(boundary, pool);
    std::vector<double> p(b.size(), 0);
    SolveReport report = solver->solve(b, enough, p, pool);
    for (auto _ : state) {
        state.PauseTiming();
        std::fill(p.begin(), p.end(), 0.0);
        state.ResumeTiming();
        report = solver->solve(b, enough, p, pool);
        state.SetIterationTime(report.solve_ms / 1000);
    }
    state.counters["iterations"] = report.iterations;
    state.counters["ns_per_cell"] =
        benchmark::Counter(static_cast<double>(n) * n / 1e9,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void prepare(benchmark::State& state, const PressureSolverEntry& entry, const Layout& layout, int n,
             int threads) {
    Pool pool(threads);
    const Boundary boundary = domain(n, layout);
    const auto solver = entry.create();
    for (auto _ : state) solver->prepare(boundary, pool);
    if (const auto* ldlt = dynamic_cast<const Ldlt*>(solver.get()))
        state.counters["factor_MB"] = static_cast<double>(ldlt->factor_entries()) * 12 / 1e6;
}

void project(benchmark::State& state, const PressureSolverEntry& entry, const Layout& layout, int n,
             int threads) {
    Pool pool(threads);
    flush_denormals();
    const Boundary boundary = domain(n, layout);
    FaceVelocity velocity = boundary.velocity();
    Field pressure = boundary.field(Site::Centre);
    Projection projection;
    projection.set_solver(static_cast<std::size_t>(&entry - pressure_solvers().data()), tolerance);
    double solve_ms = 0;
    for (auto _ : state) {
        for (int j = 1; j < n / 8; ++j) {
            for (int i = 7 * n / 16; i < 9 * n / 16; ++i) velocity.v(i, j) += Real(0.01);
        }
        solve_ms += projection.project(velocity, 1.0 / 60, boundary, pressure, pool).solve.solve_ms;
    }
    state.counters["solve_ms"] = benchmark::Counter(solve_ms, benchmark::Counter::kAvgIterations);
}

std::string name(const char* what, const PressureSolverEntry& entry, const Layout& layout, int n,
                 int threads) {
    return std::string(what) + "/" + std::string(entry.info.key) + "/" + layout.name + "/" +
           std::to_string(n) + "/threads:" + std::to_string(threads);
}

/// The sizes at which a solver is of interest: MIC(0) and LDLT take seconds beyond these.
int largest_size(std::string_view key) {
    if (key == "ldlt") return 1024;
    if (key == "conjugate-gradient") return 512;
    return key == "multigrid" ? 2048 : 1024;
}

void register_all() {
    for (const PressureSolverEntry& entry : pressure_solvers()) {
        for (const Layout& layout : layouts) {
            if (!entry.unsupported_reason(domain(64, layout)).empty()) continue;
            for (const int threads : {1, 2}) {
                for (int n = 128; n <= largest_size(entry.info.key); n *= 2) {
                    const auto add = [&](const char* what, auto&& run) {
                        return benchmark::RegisterBenchmark(
                                   name(what, entry, layout, n, threads).c_str(),
                                   [&entry, layout, n, threads, run](benchmark::State& state) {
                                       run(state, entry, layout, n, threads);
                                   })
                            ->Unit(benchmark::kMillisecond);
                    };
                    add("solve", solve)->UseManualTime();
                    add("prepare", prepare)->UseRealTime();
                    add("project", project)->UseRealTime();
                }
            }
        }
    }
}

const bool registered = (register_all(), true);

}  // namespace
