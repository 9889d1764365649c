// The number of threads changes no bit.
#include <gtest/gtest.h>

#include "tests/core/pressure/domains.h"

namespace whorl::test {
namespace {

TEST(Threads, SameBits) {
    Pool one(1);
    for (const bool periodic : {false, true}) {
        for (const bool obstacles : {false, true}) {
            for (const auto& [nx, ny] : {std::pair(150, 257), {64, 400}, {40, 40}}) {
                const Boundary boundary =
                    domain(nx, ny, periodic, obstacles ? discs(nx, ny) : std::vector<std::uint8_t>{});
                const std::vector<double> b = random_right(boundary, 9, one);
                for (const PressureSolverEntry& each : pressure_solvers()) {
                    if (!each.unsupported_reason(boundary).empty()) continue;
                    const Solution expected = solve(each, boundary, b, 1e-5, one);
                    for (const int threads : {2, 3}) {
                        Pool several(threads);
                        const Solution solution = solve(each, boundary, b, 1e-5, several);
                        EXPECT_EQ(solution.p, expected.p)
                            << each.info.key << " with " << threads << " threads";
                        EXPECT_EQ(solution.report.residual, expected.report.residual);
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace whorl::test
