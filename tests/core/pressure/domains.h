// Domains and right sides that the pressure tests share.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string_view>
#include <vector>

#include "core/pressure/components.h"
#include "core/pressure/poisson.h"
#include "core/pressure/solver.h"

namespace whorl::test {

inline Boundary domain(int nx, int ny, const Sides& sides, std::vector<std::uint8_t> solids = {}) {
    Boundary boundary(Grid{nx, ny, 1.0 / nx}, sides);
    if (!solids.empty()) boundary.set_solids(std::move(solids));
    return boundary;
}

inline Boundary domain(int nx, int ny, bool periodic, std::vector<std::uint8_t> solids = {}) {
    return domain(nx, ny, periodic ? sides::periodic : sides::box, std::move(solids));
}

/// Each cell is solid with a probability of `part`.
inline std::vector<std::uint8_t> specks(int nx, int ny, double part, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> solids(static_cast<std::size_t>(nx) * ny);
    for (auto& cell : solids) cell = std::generate_canonical<double, 32>(random) < part;
    return solids;
}

/// Discs of 3 to 10 % of the width, the same ones at any resolution.
inline std::vector<std::uint8_t> discs(int nx, int ny) {
    constexpr double centres[][3] = {{0.2, 0.3, 0.1},  {0.7, 0.25, 0.05}, {0.5, 0.6, 0.08},
                                     {0.85, 0.8, 0.1}, {0.1, 0.9, 0.03},  {0.33, 0.77, 0.06}};
    std::vector<std::uint8_t> solids(static_cast<std::size_t>(nx) * ny, 0);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            for (const auto& [x, y, r] : centres) {
                if (std::hypot((i + 0.5) / nx - x, (j + 0.5) / ny - y) < r)
                    solids[static_cast<std::size_t>(j) * nx + i] = 1;
            }
        }
    }
    return solids;
}

/// Walls of one cell across most of the domain, open at alternate ends.
inline std::vector<std::uint8_t> walls(int nx, int ny, int count) {
    std::vector<std::uint8_t> solids(static_cast<std::size_t>(nx) * ny, 0);
    for (int k = 1; k < count; ++k) {
        for (int i = 0; i < nx; ++i) {
            if (i * 8 / nx != (k % 2 ? 0 : 7))
                solids[static_cast<std::size_t>(k * ny / count + k % 3) * nx + i] = 1;
        }
    }
    return solids;
}

/// Uniform in [−1, 1], without a mean in any component.
inline std::vector<double> random_right(const Boundary& boundary, unsigned seed, Pool& pool) {
    std::mt19937 random(seed);
    std::vector<double> b(static_cast<std::size_t>(boundary.grid().nx) * boundary.grid().ny);
    for (double& value : b) value = 2 * std::generate_canonical<double, 32>(random) - 1;
    Components(boundary).remove_means(b, pool);
    return b;
}

inline double largest(const std::vector<double>& values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t c = 0; c < a.size(); ++c) most = std::max(most, std::abs(a[c] - b[c]));
    return most;
}

inline const PressureSolverEntry& entry(std::string_view key) {
    for (const PressureSolverEntry& each : pressure_solvers()) {
        if (each.info.key == key) return each;
    }
    throw std::invalid_argument("no such pressure solver");
}

inline std::size_t index_of(std::string_view key) {
    return static_cast<std::size_t>(&entry(key) - pressure_solvers().data());
}

struct Solution {
    std::vector<double> p;  ///< of mean 0 in each component
    SolveReport report;
};

/// From a guess of 0, to a residual of `tolerance` times the largest value of b.
inline Solution solve(const PressureSolverEntry& entry, const Boundary& boundary,
                      const std::vector<double>& b, double tolerance, Pool& pool) {
    Solution solution;
    solution.p.assign(b.size(), 0);
    const auto solver = entry.create();
    solver->prepare(boundary, pool);
    solution.report = solver->solve(b, tolerance * largest(b), solution.p, pool);
    Components(boundary).remove_means(solution.p, pool);
    return solution;
}

inline double residual(const Boundary& boundary, const std::vector<double>& b, const std::vector<double>& p,
                       Pool& pool) {
    Poisson poisson;
    poisson.prepare(boundary, pool);
    return relative_residual(poisson, b, p, pool);
}

}  // namespace whorl::test
