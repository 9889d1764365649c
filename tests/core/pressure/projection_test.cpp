// A projection leaves no divergence, whichever solver acts.
#include "core/pressure/projection.h"

#include <gtest/gtest.h>

#include "tests/core/pressure/domains.h"

namespace whorl::test {
namespace {

/// The bound on |∇·u| h / |u|max, and the tolerance that is to reach it.
constexpr double tolerance = 1e-5;
constexpr double dt = 1.0 / 60;
/// What single-precision velocities near 1 keep of a divergence where a projection leaves nothing of them, as
/// in one row between walls.
constexpr double rounding = 1e-6;

void randomise(FaceVelocity& velocity, unsigned seed) {
    std::mt19937 random(seed);
    for (Field* field : {&velocity.u, &velocity.v}) {
        for (int j = 0; j < field->height(); ++j) {
            for (int i = 0; i < field->width(); ++i)
                (*field)(i, j) = static_cast<Real>(2 * std::generate_canonical<double, 32>(random) - 1);
        }
    }
}

TEST(Projection, LeavesNoDivergence) {
    Pool pool(2);
    for (const PressureSolverEntry& each : pressure_solvers()) {
        for (const bool periodic : {false, true}) {
            for (const auto& [nx, ny] : {std::pair(64, 64), {37, 50}, {1, 20}, {128, 3}}) {
                for (const bool obstacles : {false, true}) {
                    const Boundary boundary =
                        domain(nx, ny, periodic, obstacles ? discs(nx, ny) : std::vector<std::uint8_t>{});
                    FaceVelocity velocity = boundary.velocity();
                    randomise(velocity, 4);
                    Field pressure = boundary.field(Site::Centre);
                    Projection projection;
                    projection.set_solver(index_of(each.info.key), tolerance);
                    const ProjectionReport report =
                        projection.project(velocity, dt, boundary, pressure, pool);
                    EXPECT_LE(report.divergence_after * boundary.grid().h,
                              tolerance * report.largest_speed + rounding)
                        << each.info.key << " " << nx << " x " << ny << (periodic ? " periodic" : " box");
                    EXPECT_FALSE(report.solver.empty());
                }
            }
        }
    }
}

/// A source of heat at the bottom accelerates the fluid above it, from rest, as the plume does.
TEST(Projection, HoldsInAPlumeFromItsFirstStep) {
    Pool pool(2);
    for (const PressureSolverEntry& each : pressure_solvers()) {
        for (const int n : {64, 256}) {
            for (const bool obstacles : {false, true}) {
                const Boundary boundary =
                    domain(n, n, false, obstacles ? discs(n, n) : std::vector<std::uint8_t>{});
                FaceVelocity velocity = boundary.velocity();
                Field pressure = boundary.field(Site::Centre);
                Projection projection;
                projection.set_solver(index_of(each.info.key), tolerance);
                for (int step = 0; step < 6; ++step) {
                    for (int j = 1; j < n / 8; ++j) {
                        for (int i = 7 * n / 16; i < 9 * n / 16; ++i) velocity.v(i, j) += Real(0.1);
                    }
                    const ProjectionReport report =
                        projection.project(velocity, dt, boundary, pressure, pool);
                    EXPECT_LE(report.divergence_after * boundary.grid().h, tolerance * report.largest_speed)
                        << each.info.key << " at " << n << ", step " << step;
                }
            }
        }
    }
}

TEST(Projection, TwiceIsOnce) {
    Pool pool(2);
    const Boundary boundary = domain(48, 48, false, discs(48, 48));
    FaceVelocity velocity = boundary.velocity();
    randomise(velocity, 1);
    Field pressure = boundary.field(Site::Centre);
    Projection projection;
    projection.set_solver(index_of("ldlt"), tolerance);
    projection.project(velocity, dt, boundary, pressure, pool);
    const FaceVelocity once = velocity;
    projection.project(velocity, dt, boundary, pressure, pool);
    for (int j = 0; j < once.u.height(); ++j) {
        for (int i = 0; i < once.u.width(); ++i) EXPECT_NEAR(once.u(i, j), velocity.u(i, j), 2 * rounding);
    }
}

/// A wall's own faces carry nothing; a solid cell's pressure is its neighbour's; the gradient acts on open
/// faces.
TEST(Projection, ClosedFacesStayClosed) {
    Pool pool(1);
    const Boundary boundary = domain(32, 32, false, discs(32, 32));
    FaceVelocity velocity = boundary.velocity();
    randomise(velocity, 2);
    Field pressure = boundary.field(Site::Centre);
    Projection projection;
    projection.set_solver(0, tolerance);
    projection.project(velocity, dt, boundary, pressure, pool);
    for (int j = 0; j < 32; ++j) {
        for (int i = 0; i <= 32; ++i) {
            if (!boundary.open_x(i, j) && boundary.solid(i - 1, j) != boundary.solid(i, j)) {
                EXPECT_EQ(velocity.u(i, j), 0);
            }
        }
    }
}

/// Flow out of a wall into a sealed room: no pressure can make it divergence-free; the mean is told, nothing
/// blows up.
TEST(Projection, TellsTheMeanItRemoves) {
    Pool pool(2);
    const int n = 24;
    std::vector<std::uint8_t> room(static_cast<std::size_t>(n) * n, 1);
    for (int j = 8; j < 16; ++j) {
        for (int i = 8; i < 16; ++i) room[static_cast<std::size_t>(j) * n + i] = 0;
    }
    const Boundary sealed = domain(n, n, false, room);
    for (const PressureSolverEntry& each : pressure_solvers()) {
        FaceVelocity velocity = sealed.velocity();
        randomise(velocity, 8);
        Field pressure = sealed.field(Site::Centre);
        Projection projection;
        projection.set_solver(index_of(each.info.key), tolerance);
        ProjectionReport report;
        for (int step = 0; step < 20; ++step)
            report = projection.project(velocity, dt, sealed, pressure, pool);
        EXPECT_NEAR(report.removed_mean, 0, 1e-3) << each.info.key;  // closed faces carry nothing
        EXPECT_TRUE(std::isfinite(report.divergence_after));
        EXPECT_LT(report.largest_speed, 2);
    }
}

}  // namespace
}  // namespace whorl::test
