// What makes multigrid worth its code: as many iterations on a fine grid as on a coarse one.
#include <gtest/gtest.h>

#include <functional>

#include "core/pressure/multigrid_cycle.h"
#include "tests/core/pressure/domains.h"

namespace whorl::test {
namespace {

/// The bound on the growth of iterations from 64² to 1024².
constexpr int most_more_iterations = 3;

using Layout = std::function<std::vector<std::uint8_t>(int)>;

void expect_flat_iterations(const Layout& layout) {
    Pool pool(2);
    for (const bool periodic : {false, true}) {
        int first = 0;
        for (const int n : {64, 128, 256, 512, 1024}) {
            const Boundary boundary = domain(n, n, periodic, layout(n));
            const std::vector<double> b = random_right(boundary, 5, pool);
            const int iterations = solve(entry("multigrid"), boundary, b, 1e-6, pool).report.iterations;
            if (first == 0) first = iterations;
            EXPECT_LE(iterations, first + most_more_iterations) << n << (periodic ? " periodic" : " box");
        }
    }
}

TEST(Multigrid, IterationsStayFlatEmpty) {
    expect_flat_iterations([](int) { return std::vector<std::uint8_t>{}; });
}
TEST(Multigrid, IterationsStayFlatAroundDiscs) {
    expect_flat_iterations([](int n) { return discs(n, n); });
}
TEST(Multigrid, IterationsStayFlatAroundSpecks) {
    expect_flat_iterations([](int n) { return specks(n, n, 0.02, 5); });
}

/// Walls of one cell, on either side of which the pressure has little to do with the other's: coarse grids
/// that took both sides for one needed 150 iterations here.
TEST(Multigrid, ThinWallsStayApartOnCoarseGrids) {
    constexpr int bound = 50;
    Pool pool(2);
    for (const bool periodic : {false, true}) {
        for (const int n : {64, 128, 256, 512}) {
            const Boundary boundary = domain(n, n, periodic, walls(n, n, 8));
            const std::vector<double> b = random_right(boundary, 5, pool);
            EXPECT_LE(solve(entry("multigrid"), boundary, b, 1e-6, pool).report.iterations, bound)
                << n << (periodic ? " periodic" : " box");
        }
    }
}

/// x·(M y) = y·(M x): conjugate gradient needs a symmetric cycle. In single precision, so to its rounding.
TEST(Multigrid, CycleIsSymmetric) {
    constexpr double single_rounding = 2e-5;
    Pool pool(2);
    for (const bool periodic : {false, true}) {
        for (const auto& [nx, ny] : {std::pair(1, 9), {6, 5}, {7, 7}, {33, 17}, {40, 64}}) {
            for (const double part : {0.0, 0.1, 0.4}) {
                const Boundary boundary = domain(nx, ny, periodic, specks(nx, ny, part, 11));
                Poisson poisson;
                poisson.prepare(boundary, pool);
                Levels levels;
                levels.prepare(boundary, poisson, pool);
                const auto apply = [&](const std::vector<double>& r) {
                    levels.fine.b = r.data();
                    v_cycle(levels, pool);
                    std::vector<double> z;
                    for (int j = 0; j < ny; ++j)
                        z.insert(z.end(), levels.fine.work.whole.row(j), levels.fine.work.whole.row(j) + nx);
                    return z;
                };
                const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
                    double sum = 0;
                    for (std::size_t c = 0; c < a.size(); ++c) sum += a[c] * b[c];
                    return sum;
                };
                const std::vector<double> x = random_right(boundary, 1, pool);
                const std::vector<double> y = random_right(boundary, 2, pool);
                const std::vector<double> mx = apply(x);
                const std::vector<double> my = apply(y);
                const double scale = std::sqrt(dot(x, x) * dot(my, my)) + 1e-30;
                EXPECT_NEAR(dot(x, my) / scale, dot(y, mx) / scale, single_rounding)
                    << nx << " x " << ny << (periodic ? " periodic " : " box ") << part;
                EXPECT_GE(dot(x, mx), 0);
            }
        }
    }
}

TEST(Multigrid, StartsFromTheGuess) {
    Pool pool(1);
    const Boundary boundary = domain(64, 64, false, discs(64, 64));
    const std::vector<double> b = random_right(boundary, 5, pool);
    for (const char* key : {"multigrid", "conjugate-gradient"}) {
        const auto solver = entry(key).create();
        solver->prepare(boundary, pool);
        std::vector<double> p(b.size(), 0);
        const int cold = solver->solve(b, 1e-8, p, pool).iterations;
        EXPECT_EQ(solver->solve(b, 1e-8, p, pool).iterations, 0) << key;
        for (double& value : p) value *= 0.999;
        EXPECT_LT(solver->solve(b, 1e-8, p, pool).iterations, cold) << key;
    }
}

}  // namespace
}  // namespace whorl::test
