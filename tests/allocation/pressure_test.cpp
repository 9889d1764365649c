// A solve allocates nothing after the first, and neither does a projection.
#include <gtest/gtest.h>

#include "core/pressure/projection.h"
#include "tests/core/pressure/domains.h"
#include "tests/support/allocations.h"

namespace whorl::test {
namespace {

TEST(Allocation, NoneInASolveAfterTheFirst) {
    Pool pool(2);
    for (const bool obstacles : {false, true}) {
        const Boundary boundary =
            domain(96, 80, false, obstacles ? discs(96, 80) : std::vector<std::uint8_t>{});
        for (const PressureSolverEntry& each : pressure_solvers()) {
            if (!each.unsupported_reason(boundary).empty()) continue;
            const std::vector<double> b = random_right(boundary, 3, pool);
            std::vector<double> p(b.size(), 0);
            const auto solver = each.create();
            solver->prepare(boundary, pool);
            solver->solve(b, 1e-6, p, pool);
            std::fill(p.begin(), p.end(), 0.0);
            const long before = allocations();
            solver->solve(b, 1e-6, p, pool);
            EXPECT_EQ(allocations(), before) << each.info.key;
        }
    }
}

TEST(Allocation, NoneInAProjectionAfterTheFirst) {
    Pool pool(2);
    for (const PressureSolverEntry& each : pressure_solvers()) {
        const Boundary boundary = domain(64, 64, true, discs(64, 64));
        FaceVelocity velocity = boundary.velocity();
        Field pressure = boundary.field(Site::Centre);
        Projection projection;
        projection.set_solver(index_of(each.info.key), 1e-5);
        velocity.v(20, 20) = 1;
        projection.project(velocity, 0.1, boundary, pressure, pool);
        velocity.v(40, 20) = 1;
        const long before = allocations();
        projection.project(velocity, 0.1, boundary, pressure, pool);
        EXPECT_EQ(allocations(), before) << each.info.key;
    }
}

}  // namespace
}  // namespace whorl::test
