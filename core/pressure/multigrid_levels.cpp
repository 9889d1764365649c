#include "core/pressure/multigrid_levels.h"

#include <algorithm>
#include <cstdlib>

#include "core/parallel/row_bands.h"
#include "core/pressure/poisson_rows.h"

namespace whorl {
namespace {

/// A child's centre lies a quarter of a coarse cell from its parent's, in x and in y: linear interpolation
/// over three centres.  [Wesseling 1992, sec. 5.4]
constexpr float lean = 0.25F;

int half_up(int n) {
    return (n + 1) / 2;
}

void resize(LevelWork& work, int nx, int ny) {
    work.half.resize(nx, ny);
    work.whole.resize(nx, ny);
    work.scratch.resize(nx, ((ny + rows_of_unit - 1) / rows_of_unit) * rows_of_scratch);
}

void resize(CoarseLevel& level) {
    const auto [nx, ny, wraps_x, wraps_y] = level.shape;
    level.across.resize(nx + 1, ny);
    level.lean_across.resize(nx + 1, ny);
    level.along.resize(nx, ny + 1);
    level.lean_along.resize(nx, ny + 1);
    level.inverse.resize(nx, ny);
    level.b.resize(nx, ny);
    resize(level.work, nx, ny);
}

/// Adds to the coefficient of the face between two coarse cells, if they have one.
void change_face(CoarseLevel& level, int i0, int j0, int i1, int j1, float amount) {
    const auto [nx, ny, wraps_x, wraps_y] = level.shape;
    const int i = std::max(i0, i1);
    const int j = std::max(j0, j1);
    if (j0 == j1 && std::abs(i0 - i1) == 1) {
        level.across.row(j)[i] += amount;
    } else if (i0 == i1 && std::abs(j0 - j1) == 1) {
        level.along.row(j)[i] += amount;
    } else if (j0 == j1 && wraps_x && std::abs(i0 - i1) == nx - 1) {
        level.across.row(j)[0] += amount;
        level.across.row(j)[nx] += amount;
    } else if (i0 == i1 && wraps_y && std::abs(j0 - j1) == ny - 1) {
        level.along.row(0)[i] += amount;
        level.along.row(ny)[i] += amount;
    }
}

/// Fills a level from the faces of the finer one: `open_x(i, j)`, `open_y(i, j)` are their coefficients.
template <class X, class Y>
void coarsen(const LevelShape& fine, CoarseLevel& level, bool walls, Pool& pool, X&& open_x, Y&& open_y) {
    const LevelShape& shape = level.shape;
    // A face between two coarse centres: two fine faces side by side, twice as far apart.
    const bool no_x = shape.nx == 1;
    const bool no_y = shape.ny == 1;
    row_bands(pool, shape.nx, shape.ny + 1, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const int low = std::min(2 * j, fine.ny);
            float* along = level.along.row(j);
            for (int i = 0; i < shape.nx; ++i) {
                const float second = 2 * i + 1 < fine.nx ? open_y(2 * i + 1, low) : 0;
                along[i] = no_y ? 0 : (open_y(2 * i, low) + second) / 2;
            }
            if (j == shape.ny) continue;
            float* across = level.across.row(j);
            for (int i = 0; i <= shape.nx; ++i) {
                const int left = std::min(2 * i, fine.nx);
                const float second = 2 * j + 1 < fine.ny ? open_x(left, 2 * j + 1) : 0;
                across[i] = no_x ? 0 : (open_x(left, 2 * j) + second) / 2;
            }
        }
    });
    level.aggregation.clear();
    if (walls) {
        level.aggregation.find(fine, shape, open_x, open_y);
        level.aggregation.move_faces(open_x, open_y, [&](int i0, int j0, int i1, int j1, float amount) {
            change_face(level, i0, j0, i1, j1, amount);
        });
    }
    row_bands(pool, shape.nx, shape.ny, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const float* across = level.across.row(j);
            const float* south = level.along.row(j);
            const float* north = level.along.row(j + 1);
            float* inverse = level.inverse.row(j);
            float* lean_south = level.lean_along.row(j);
            float* lean_across = level.lean_across.row(j);
            for (int i = 0; i < shape.nx; ++i) {
                const float sum = across[i] + across[i + 1] + south[i] + north[i];
                inverse[i] = sum > 0 ? 1 / sum : 0;
                lean_south[i] = south[i] > 0 ? lean : 0;
            }
            for (int i = 0; i <= shape.nx; ++i) lean_across[i] = across[i] > 0 ? lean : 0;
        }
    });
    const float* last = level.along.row(shape.ny);
    float* lean_last = level.lean_along.row(shape.ny);
    for (int i = 0; i < shape.nx; ++i) lean_last[i] = last[i] > 0 ? lean : 0;
}

}  // namespace

void FineLevel::first_smoothing(int j, float w, float* out) const {
    rows::first_smoothing(poisson->degrees(j), b + static_cast<std::size_t>(j) * shape.nx, w, out, shape.nx);
}
void FineLevel::smoothing(int j, const float* south, const float* here, const float* north, float w,
                          float* out) const {
    rows::smoothing(poisson->degrees(j), b + static_cast<std::size_t>(j) * shape.nx, south, here, north, w,
                    out, shape.nx);
}
void FineLevel::residual(int j, const float* south, const float* here, const float* north, float* out) const {
    rows::smoothed_residual(poisson->degrees(j), b + static_cast<std::size_t>(j) * shape.nx, south, here,
                            north, out, shape.nx);
}
void FineLevel::after_carry(int j, float* row) const {
    rows::mask(poisson->degrees(j), row, shape.nx);
}

void FineLevel::finished(int j, const float* row) const {
    row_dots[j] = rows::dot(b + static_cast<std::size_t>(j) * shape.nx, row, shape.nx);
}

void Levels::prepare(const Boundary& boundary, const Poisson& poisson, Pool& pool) {
    const LevelShape shape{poisson.nx(), poisson.ny(), poisson.wraps_x(), poisson.wraps_y()};
    const bool same = shape.nx == fine.shape.nx && shape.ny == fine.shape.ny;
    fine.poisson = &poisson;
    fine.shape = shape;
    fine.row_dots.assign(static_cast<std::size_t>(shape.ny), 0);
    if (!same) {
        resize(fine.work, shape.nx, shape.ny);
        coarse.clear();
        for (LevelShape s = shape; s.nx > 1 || s.ny > 1;) {
            s.nx = half_up(s.nx);
            s.ny = half_up(s.ny);
            coarse.emplace_back().shape = s;
            resize(coarse.back());
        }
    }
    const LevelShape* finer = &fine.shape;
    for (CoarseLevel& level : coarse) {
        level.shape.wraps_x = finer->wraps_x && level.shape.nx > 1;
        level.shape.wraps_y = finer->wraps_y && level.shape.ny > 1;
        finer = &level.shape;
    }
    if (coarse.empty()) return;

    const std::uint8_t* solids = boundary.solids().data();
    const auto fluid = [&](int i, int j) { return solids[static_cast<std::size_t>(j) * shape.nx + i] == 0; };
    const auto open_x = [&](int i, int j) {
        if (i > 0 && i < shape.nx) return fluid(i - 1, j) && fluid(i, j) ? 1.0F : 0.0F;
        return shape.wraps_x && fluid(shape.nx - 1, j) && fluid(0, j) ? 1.0F : 0.0F;
    };
    const auto open_y = [&](int i, int j) {
        if (j > 0 && j < shape.ny) return fluid(i, j - 1) && fluid(i, j) ? 1.0F : 0.0F;
        return shape.wraps_y && fluid(i, shape.ny - 1) && fluid(i, 0) ? 1.0F : 0.0F;
    };
    coarsen(shape, coarse[0], boundary.has_solids(), pool, open_x, open_y);
    for (std::size_t k = 1; k < coarse.size(); ++k) {
        const CoarseLevel& from = coarse[k - 1];
        coarsen(
            from.shape, coarse[k], boundary.has_solids(), pool,
            [&](int i, int j) { return from.across.row(j)[i]; },
            [&](int i, int j) { return from.along.row(j)[i]; });
    }
}

}  // namespace whorl
