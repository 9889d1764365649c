// Every listed solver gives the same pressure, whatever the walls.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/core/pressure/domains.h"
#include "tests/support/channel.h"

namespace whorl::test {
namespace {

/// What iterations are asked for here.
constexpr double asked = 1e-9;
/// Residual over the right side's largest value: what was asked, and the rounding of a direct solve with a
/// condition number up to some 10⁵.
constexpr double residual_bound = 2e-9;

/// A residual of `asked` leaves an error of at most that over A's least eigenvalue, which is at worst about
/// 10 / (cells of the longest way)²; its sum over cells stays well below this bound on a pressure near 1.
double pressure_bound(const Boundary& boundary) {
    const double cells = boundary.fluid_cells();
    return asked * (1 + cells * cells);
}

void expect_agreement(const Boundary& boundary, unsigned seed, Pool& pool) {
    const std::vector<double> b = random_right(boundary, seed, pool);
    const Solution reference = solve(entry("ldlt"), boundary, b, asked, pool);
    for (const PressureSolverEntry& each : pressure_solvers()) {
        if (!each.unsupported_reason(boundary).empty()) continue;
        SCOPED_TRACE(each.info.key);
        const Solution solution = solve(each, boundary, b, asked, pool);
        for (const double value : solution.p) ASSERT_TRUE(std::isfinite(value));
        EXPECT_LE(residual(boundary, b, solution.p, pool), residual_bound);
        EXPECT_LE(largest_difference(solution.p, reference.p),
                  pressure_bound(boundary) * (1 + largest(reference.p)));
    }
}

constexpr std::pair<int, int> sizes[] = {{1, 1},   {1, 2},   {2, 1},   {1, 3},   {1, 17}, {33, 1},  {1, 64},
                                         {2, 2},   {3, 2},   {2, 5},   {3, 3},   {5, 4},  {16, 16}, {17, 17},
                                         {31, 64}, {64, 30}, {100, 7}, {3, 120}, {96, 96}};

TEST(Agreement, WithoutObstacles) {
    Pool pool(2);
    for (const Sides& sides : all_sides) {
        for (const auto& [nx, ny] : sizes) {
            SCOPED_TRACE(testing::Message() << nx << " x " << ny << " " << name(sides));
            expect_agreement(domain(nx, ny, sides), 7, pool);
        }
    }
}

TEST(Agreement, HundredRandomLayouts) {
    Pool pool(2);
    const bool held = rc::check("solvers agree on random layouts", [&] {
        const int nx = *rc::gen::inRange(1, 49);
        const int ny = *rc::gen::inRange(1, 49);
        const Sides& sides = all_sides[*rc::gen::inRange<std::size_t>(0, std::size(all_sides))];
        const double part = *rc::gen::element(0.02, 0.1, 0.3, 0.6, 0.9);
        const auto seed = *rc::gen::arbitrary<std::uint16_t>();
        const Boundary boundary = domain(nx, ny, sides, specks(nx, ny, part, seed));
        const std::vector<double> b = random_right(boundary, seed, pool);
        const Solution reference = solve(entry("ldlt"), boundary, b, asked, pool);
        for (const PressureSolverEntry& each : pressure_solvers()) {
            if (!each.unsupported_reason(boundary).empty()) continue;
            RC_LOG() << each.info.key << "\n";
            const Solution solution = solve(each, boundary, b, asked, pool);
            RC_ASSERT(residual(boundary, b, solution.p, pool) <= residual_bound);
            RC_ASSERT(largest_difference(solution.p, reference.p) <=
                      pressure_bound(boundary) * (1 + largest(reference.p)));
        }
    });
    EXPECT_TRUE(held);
}

TEST(Agreement, WallsAndPockets) {
    Pool pool(2);
    std::vector<std::uint8_t> pocket(40 * 30, 0);
    for (int k = 10; k <= 20; ++k)
        pocket[10 * 40 + k] = pocket[20 * 40 + k] = pocket[k * 40 + 10] = pocket[k * 40 + 20] = 1;
    std::vector<std::uint8_t> one_cell = pocket;
    for (int j = 11; j < 20; ++j) {
        for (int i = 11; i < 20; ++i) one_cell[j * 40 + i] = i != 15 || j != 15;
    }
    for (const Sides& sides : all_sides) {
        SCOPED_TRACE(name(sides));
        expect_agreement(domain(40, 30, sides, pocket), 1, pool);
        expect_agreement(domain(40, 30, sides, one_cell), 2, pool);
        expect_agreement(domain(40, 30, sides, walls(40, 30, 6)), 3, pool);
        expect_agreement(domain(64, 64, sides, discs(64, 64)), 4, pool);
    }
}

TEST(Agreement, NoFluidNoTrouble) {
    Pool pool(2);
    for (const auto& [nx, ny] : {std::pair(1, 1), {5, 4}, {32, 32}}) {
        const Boundary boundary =
            domain(nx, ny, false, std::vector<std::uint8_t>(static_cast<std::size_t>(nx) * ny, 1));
        const std::vector<double> b(static_cast<std::size_t>(nx) * ny, 0);
        for (const PressureSolverEntry& each : pressure_solvers()) {
            if (!each.unsupported_reason(boundary).empty()) continue;
            const Solution solution = solve(each, boundary, b, asked, pool);
            EXPECT_EQ(largest(solution.p), 0) << each.info.key;
        }
    }
}

TEST(Agreement, AnyUnit) {
    Pool pool(1);
    const Boundary boundary = domain(48, 32, false, discs(48, 32));
    for (const double unit : {1e-200, 1e-30, 1e30, 1e200}) {
        std::vector<double> b = random_right(boundary, 3, pool);
        for (double& value : b) value *= unit;
        for (const char* key : {"multigrid", "conjugate-gradient"}) {
            const Solution solution = solve(entry(key), boundary, b, 1e-6, pool);
            EXPECT_LE(residual(boundary, b, solution.p, pool), 1.01e-6) << key << " in units of " << unit;
        }
    }
}

TEST(Agreement, DiagonalizationSaysWhyItIsNotOffered) {
    EXPECT_TRUE(entry("diagonalization").unsupported_reason(domain(8, 8, false)).empty());
    EXPECT_FALSE(entry("diagonalization").unsupported_reason(domain(8, 8, false, discs(8, 8))).empty());
}

}  // namespace
}  // namespace whorl::test
