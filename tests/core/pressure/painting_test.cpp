// Painting walls never waits for a factorisation, and a replay of it gives the same bits.
#include <gtest/gtest.h>

#include "core/pressure/projection.h"
#include "core/pressure/solver_selector.h"
#include "tests/core/pressure/domains.h"

namespace whorl::test {
namespace {

constexpr int n = 32;
constexpr double dt = 1.0 / 60;

/// A wall that grows by a cell in each of the first `strokes` projections.
struct Painted {
    std::vector<std::string> solvers;
    FaceVelocity velocity;
};

Painted paint(std::string_view solver, int first_stroke, int strokes, int projections, Pool& pool) {
    Boundary boundary = domain(n, n, false);
    Painted run{{}, boundary.velocity()};
    Field pressure = boundary.field(Site::Centre);
    Projection projection;
    projection.set_solver(index_of(solver), 1e-5);
    std::vector<std::uint8_t> solids(static_cast<std::size_t>(n) * n, 0);
    for (int k = 0; k < projections; ++k) {
        if (k >= first_stroke && k < first_stroke + strokes) {
            solids[static_cast<std::size_t>(n / 2) * n + static_cast<std::size_t>(k % n)] = 1;
            boundary.set_solids(solids);
        }
        run.velocity.v(n / 2, 2) += Real(0.1);
        run.solvers.emplace_back(projection.project(run.velocity, dt, boundary, pressure, pool).solver);
    }
    return run;
}

TEST(Painting, AStandInActsUntilTheWallsHaveRested) {
    Pool pool(2);
    const int back =
        5 + SolverSelector::projections_at_rest + SolverSelector::projections_to_prepare({n, n, 1});
    const Painted run = paint("ldlt", 3, 3, back + 4, pool);
    for (int k = 0; k < back + 4; ++k) {
        const bool away = k >= 3 && k < back;
        EXPECT_EQ(run.solvers[k], away ? "multigrid" : "ldlt") << "projection " << k;
    }
}

TEST(Painting, AgainWhileTheSolverIsOnItsWay) {
    Pool pool(2);
    // Strokes so far apart that each starts a preparation that the next one outdates.
    Boundary boundary = domain(n, n, false);
    FaceVelocity velocity = boundary.velocity();
    Field pressure = boundary.field(Site::Centre);
    Projection projection;
    projection.set_solver(index_of("ldlt"), 1e-5);
    std::vector<std::uint8_t> solids(static_cast<std::size_t>(n) * n, 0);
    for (int k = 0; k < 100; ++k) {
        if (k % SolverSelector::projections_at_rest == 0 && k < 60) {
            solids[static_cast<std::size_t>(k) * 3] = 1;
            boundary.set_solids(solids);
        }
        velocity.v(n / 2, 2) += Real(0.1);
        const ProjectionReport report = projection.project(velocity, dt, boundary, pressure, pool);
        EXPECT_LE(report.divergence_after * boundary.grid().h, 1e-5 * report.largest_speed) << k;
    }
}

TEST(Painting, SolversWithoutAFactorActAtOnce) {
    Pool pool(1);
    for (const char* key : {"multigrid", "conjugate-gradient"}) {
        for (const std::string& solver : paint(key, 2, 3, 8, pool).solvers) EXPECT_EQ(solver, key);
    }
    const Painted direct = paint("diagonalization", 2, 3, 8, pool);
    EXPECT_EQ(direct.solvers[1], "diagonalization");
    EXPECT_EQ(direct.solvers[7], "multigrid");  // not offered where there are obstacles
}

TEST(Painting, AReplayGivesTheSameBits) {
    Pool one(1);
    Pool two(2);
    for (const char* key : {"ldlt", "auto"}) {
        const Painted first = paint(key, 3, 5, 40, one);
        const Painted again = paint(key, 3, 5, 40, two);
        EXPECT_EQ(first.solvers, again.solvers);
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                ASSERT_EQ(first.velocity.u(i, j), again.velocity.u(i, j));
                ASSERT_EQ(first.velocity.v(i, j), again.velocity.v(i, j));
            }
        }
    }
}

}  // namespace
}  // namespace whorl::test
