// Manufactured solutions: the pressure and its gradient are of second order.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/core/pressure/domains.h"

namespace whorl::test {
namespace {

constexpr double pi = std::numbers::pi;
/// Below the discretisation error of the finest grid here, 10⁻⁴ of the pressure.
constexpr double asked = 1e-10;
/// Second order divides the error by 4 as h is halved; the next term of the series is a few percent of it
/// here.
constexpr double least_ratio = 3.75;

struct Errors {
    double pressure;
    double gradient;
};

/// p = cos(aπx) cos(bπy) on the unit square: no normal gradient at its sides, and periodic if a and b are
/// even.
Errors errors(const PressureSolverEntry& solver, int n, bool periodic, Pool& pool) {
    const double a = periodic ? 2 : 1;
    const double b = periodic ? 4 : 2;
    const double h = 1.0 / n;
    const auto exact = [&](double x, double y) { return std::cos(a * pi * x) * std::cos(b * pi * y); };
    const Boundary boundary = domain(n, n, periodic);
    std::vector<double> right(static_cast<std::size_t>(n) * n);
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i)
            right[static_cast<std::size_t>(j) * n + i] =
                h * h * (a * a + b * b) * pi * pi * exact((i + 0.5) * h, (j + 0.5) * h);
    }
    Components(boundary).remove_means(right, pool);
    const Solution solution = solve(solver, boundary, right, asked, pool);
    Errors out{0, 0};
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double p = solution.p[static_cast<std::size_t>(j) * n + i];
            out.pressure = std::max(out.pressure, std::abs(p - exact((i + 0.5) * h, (j + 0.5) * h)));
            if (i == 0) continue;
            const double slope = (p - solution.p[static_cast<std::size_t>(j) * n + i - 1]) / h;
            const double exact_slope = -a * pi * std::sin(a * pi * i * h) * std::cos(b * pi * (j + 0.5) * h);
            out.gradient = std::max(out.gradient, std::abs(slope - exact_slope));
        }
    }
    return out;
}

TEST(Convergence, SecondOrder) {
    Pool pool(2);
    for (const PressureSolverEntry& each : pressure_solvers()) {
        for (const bool periodic : {false, true}) {
            SCOPED_TRACE(testing::Message() << each.info.key << (periodic ? " periodic" : " box"));
            Errors coarse = errors(each, 16, periodic, pool);
            for (const int n : {32, 64, 128}) {
                const Errors fine = errors(each, n, periodic, pool);
                EXPECT_GT(coarse.pressure / fine.pressure, least_ratio) << "at " << n;
                EXPECT_GT(coarse.gradient / fine.gradient, least_ratio) << "at " << n;
                coarse = fine;
            }
        }
    }
}

}  // namespace
}  // namespace whorl::test
