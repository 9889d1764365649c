#include "core/pressure/projection.h"

#include <algorithm>
#include <cmath>

namespace whorl {
namespace {

double largest_divergence(const FaceVelocity& velocity, const Boundary& boundary) {
    const Grid& grid = boundary.grid();
    double largest = 0;
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            if (boundary.has_solids() && boundary.solid(i, j)) continue;
            largest = std::max(largest, std::abs(divergence(velocity, i, j, grid.h)));
        }
    }
    return largest;
}

double largest_value(const Field& field) {
    double largest = 0;
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i)
            largest = std::max(largest, std::abs(static_cast<double>(field(i, j))));
    }
    return largest;
}

}  // namespace

void Projection::set_solver(std::size_t index, double tolerance) {
    if (solver_ && index == index_ && tolerance == tolerance_) return;
    index_ = index;
    tolerance_ = tolerance;
    solver_ = pressure_solvers()[index].create(tolerance);
    prepared_grid_ = {};
}

ProjectionReport Projection::project(FaceVelocity& velocity, double dt, const Boundary& boundary,
                                     Field& pressure, Pool& pool) {
    const Grid& grid = boundary.grid();
    const std::size_t cells = static_cast<std::size_t>(grid.nx) * grid.ny;
    if (!(prepared_grid_ == grid) || prepared_periodic_ != boundary.periodic() ||
        prepared_solids_ != boundary.solids()) {
        components_ = Components(boundary);
        solver_->prepare(boundary, pool);
        prepared_grid_ = grid;
        prepared_periodic_ = boundary.periodic();
        prepared_solids_ = boundary.solids();
        right_.assign(cells, 0);
        p_.assign(cells, 0);
    }

    ProjectionReport report;
    boundary.enforce(velocity);
    report.divergence_before = largest_divergence(velocity, boundary);
    const double scale = -grid.h * grid.h / dt;  // A is −h² ∇²
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            right_[static_cast<std::size_t>(j) * grid.nx + i] = scale * divergence(velocity, i, j, grid.h);
        }
    }
    report.removed_mean = components_.remove_means(right_) / scale;
    report.solve = solver_->solve(right_, p_, pool);
    components_.remove_means(p_);

    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            pressure(i, j) = static_cast<Real>(p_[static_cast<std::size_t>(j) * grid.nx + i]);
        }
    }
    boundary.fill(pressure);

    // Faces that fluid may cross lose the gradient; in double, for pressures differ little from cell to cell.
    const double factor = dt / grid.h;
    const auto p_at = [&](int i, int j) {
        return p_[static_cast<std::size_t>((j + grid.ny) % grid.ny) * grid.nx + (i + grid.nx) % grid.nx];
    };
    for (int j = 0; j < velocity.u.height(); ++j) {
        for (int i = 0; i < velocity.u.width(); ++i) {
            if (!boundary.open_x(i, j)) continue;
            velocity.u(i, j) = static_cast<Real>(static_cast<double>(velocity.u(i, j)) -
                                                 factor * (p_at(i, j) - p_at(i - 1, j)));
        }
    }
    for (int j = 0; j < velocity.v.height(); ++j) {
        for (int i = 0; i < velocity.v.width(); ++i) {
            if (!boundary.open_y(i, j)) continue;
            velocity.v(i, j) = static_cast<Real>(static_cast<double>(velocity.v(i, j)) -
                                                 factor * (p_at(i, j) - p_at(i, j - 1)));
        }
    }
    boundary.fill(velocity);
    report.divergence_after = largest_divergence(velocity, boundary);
    report.largest_speed = std::max(largest_value(velocity.u), largest_value(velocity.v));
    return report;
}

}  // namespace whorl
