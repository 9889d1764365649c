#include "core/pressure/projection.h"

#include <algorithm>
#include <cmath>

#include "core/parallel/row_bands.h"
#include "core/pressure/projection_rows.h"

namespace whorl {
namespace {

/// The part of the largest speed that a projection is sure to leave. What is left of u* decides how much
/// divergence may stay, but is not known before; in the plume it is 0.4 or more of u*, at the first step.
constexpr double speed_that_stays = 0.25;

}  // namespace

void Projection::set_solver(std::size_t index, double tolerance) {
    tolerance_ = tolerance;
    selector_.choose(index);
}

/// Remembers a boundary, and says how it differs from the last one.
SolverSelector::Change Projection::take(const Boundary& boundary) {
    const Grid& grid = boundary.grid();
    auto change = SolverSelector::Change::None;
    if (!(grid_ == grid) || sides_ != boundary.sides()) {
        change = SolverSelector::Change::Domain;
        const std::size_t cells = static_cast<std::size_t>(grid.nx) * grid.ny;
        right_.assign(cells, 0);
        p_.assign(cells, 0);
        row_largest_.assign(static_cast<std::size_t>(grid.ny) + 1, 0);
    } else if (solids_ != boundary.solids()) {
        change = SolverSelector::Change::Walls;
    }
    if (change != SolverSelector::Change::None) {
        grid_ = grid;
        sides_ = boundary.sides();
        solids_ = boundary.solids();
        components_ = Components(boundary);
    }
    return change;
}

void Projection::look_at(const Boundary& boundary, Pool& pool) {
    const SolverSelector::Change change = take(boundary);
    if (change != SolverSelector::Change::None) components_.remove_means(p_, pool);  // 0 in cells now solid
    selector_.follow(boundary, change, pool);
}

void Projection::restore(const Memory& memory, const Boundary& boundary, Pool& pool) {
    const bool same = take(boundary) == SolverSelector::Change::None;
    if (memory.pressure.empty()) {
        std::fill(p_.begin(), p_.end(), 0);
    } else {
        p_ = memory.pressure;
    }
    selector_.restore(memory.solver, boundary, same, pool);
    if (memory.new_walls) solids_.clear();
}

ProjectionReport Projection::project(FaceVelocity& velocity, double dt, const Boundary& boundary,
                                     Field& pressure, Pool& pool) {
    look_at(boundary, pool);
    const double h = grid_.h;
    ProjectionReport report;
    boundary.enforce(velocity);
    const double scale = -h / dt;  // A is −h² ∇², and an outflow h ∇·u
    report.divergence_before = set_right(velocity, scale, pool) / h;
    report.removed_mean = components_.remove_means(right_, pool) / (scale * h);
    const double enough =
        tolerance_ * std::abs(scale) *
        std::min(report.divergence_before * h, speed_that_stays * largest_speed(velocity, pool));
    report.solve = selector_.solver().solve(right_, enough, p_, pool);
    report.solver = report.solve.solver;
    report.unsupported_reason = selector_.unsupported_reason();
    components_.remove_means(p_, pool);

    row_bands(pool, grid_.nx, grid_.ny, [&](int begin, int end) {
        for (int j = begin; j < end; ++j)
            rows::to_field(p_.data() + static_cast<std::size_t>(j) * grid_.nx, pressure.row(j), grid_.nx);
    });
    boundary.fill(pressure);
    correct(velocity, dt / h, pool);
    boundary.fill(velocity);
    report.divergence_after = largest_outflow(velocity, pool) / h;
    report.largest_speed = largest_speed(velocity, pool);
    return report;
}

/// right = scale × outflow.
/// @return the largest outflow, by size
double Projection::set_right(const FaceVelocity& velocity, double scale, Pool& pool) {
    row_bands(pool, grid_.nx, grid_.ny, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const std::size_t at = static_cast<std::size_t>(j) * grid_.nx;
            row_largest_[j] = rows::outflows(solids_.data() + at, velocity.u.row(j), velocity.v.row(j),
                                             velocity.v.row(j + 1), scale, right_.data() + at, grid_.nx);
        }
    });
    return largest_of_rows(grid_.ny);
}

double Projection::largest_outflow(const FaceVelocity& velocity, Pool& pool) {
    row_bands(pool, grid_.nx, grid_.ny, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            row_largest_[j] =
                rows::largest_outflow(solids_.data() + static_cast<std::size_t>(j) * grid_.nx,
                                      velocity.u.row(j), velocity.v.row(j), velocity.v.row(j + 1), grid_.nx);
        }
    });
    return largest_of_rows(grid_.ny);
}

double Projection::largest_speed(const FaceVelocity& velocity, Pool& pool) {
    row_bands(pool, grid_.nx, grid_.ny + 1, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const double u =
                j < velocity.u.height() ? rows::largest_value(velocity.u.row(j), velocity.u.width()) : 0;
            const double v =
                j < velocity.v.height() ? rows::largest_value(velocity.v.row(j), velocity.v.width()) : 0;
            row_largest_[j] = std::max(u, v);
        }
    });
    return largest_of_rows(grid_.ny + 1);
}

double Projection::largest_of_rows(int rows) const {
    return *std::max_element(row_largest_.begin(), row_largest_.begin() + rows);
}

/// Faces that fluid may cross lose factor × the pressure's difference.
void Projection::correct(FaceVelocity& velocity, double factor, Pool& pool) const {
    const int nx = grid_.nx;
    const int ny = grid_.ny;
    const Wraps wraps = sides_.wraps();
    row_bands(pool, nx, ny, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const std::size_t at = static_cast<std::size_t>(j) * nx;
            const double* p = p_.data() + at;
            const std::uint8_t* solid = solids_.data() + at;
            rows::subtract_gradient(solid, solid + 1, p, p + 1, factor, velocity.u.row(j) + 1, nx - 1);
            if (wraps.x)
                rows::subtract_gradient(solid + nx - 1, solid, p + nx - 1, p, factor, velocity.u.row(j), 1);
            if (j == 0 && !wraps.y) continue;
            const std::size_t below = static_cast<std::size_t>(j > 0 ? j - 1 : ny - 1) * nx;
            rows::subtract_gradient(solids_.data() + below, solid, p_.data() + below, p, factor,
                                    velocity.v.row(j), nx);
        }
    });
}

}  // namespace whorl
