#include "core/measure/measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/measure/vorticity.h"
#include "core/parallel/lanes.h"

namespace whorl {
namespace {

/// The samples in and around a row of cells.
struct CellRow {
    const Real* density;
    const Real* heat;
    const Real* u;
    const Real* v;
    const Real* v_above;
    const Real* vorticity;
};

void add_cell(const CellRow& cells, int i, RowSums& row) {
    const auto at = [i](const Real* samples) { return static_cast<double>(samples[i]); };
    const double rho = at(cells.density), w = at(cells.vorticity);
    const double left = at(cells.u), right = at(cells.u + 1), low = at(cells.v), high = at(cells.v_above);
    row.density += rho;
    row.heat += at(cells.heat);
    row.min = std::min(row.min, rho);
    row.max = std::max(row.max, rho);
    // Each face belongs half to either cell.
    row.energy += 0.25 * (left * left + right * right + low * low + high * high);
    row.enstrophy += 0.5 * w * w;
    row.speed = std::max({row.speed, std::abs(left), std::abs(right), std::abs(low), std::abs(high)});
}

/// The same for as many cells as fill whole vectors, four sums side by side. @return how many
int add_vectors(const CellRow& cells, int count, RowSums& row) {
    using T = RealLanes<16>;
    constexpr int lanes = lane_count<T>;
    using Wide __attribute__((vector_size(lanes * sizeof(double)))) = double;
    const int end = count - count % lanes;
    if (end == 0) return 0;
    Wide density{}, heat{}, energy{}, enstrophy{};
    T min = load<T>(cells.density), max = min, speed{};
    for (int i = 0; i < end; i += lanes) {
        const T rho = load<T>(cells.density + i);
        min = smaller(rho, min);
        max = larger(rho, max);
        density += __builtin_convertvector(rho, Wide);
        heat += __builtin_convertvector(load<T>(cells.heat + i), Wide);
        Wide squares{};
        for (const Real* face : {cells.u, cells.u + 1, cells.v, cells.v_above}) {
            const T velocity = load<T>(face + i);
            const Wide wide = __builtin_convertvector(velocity, Wide);
            squares += wide * wide;
            speed = larger(larger(velocity, -velocity), speed);
        }
        energy += 0.25 * squares;
        const Wide w = __builtin_convertvector(load<T>(cells.vorticity + i), Wide);
        enstrophy += 0.5 * w * w;
    }
    for (int k = 0; k < lanes; ++k) {
        row.density += density[k];
        row.heat += heat[k];
        row.energy += energy[k];
        row.enstrophy += enstrophy[k];
        row.min = std::min(row.min, static_cast<double>(min[k]));
        row.max = std::max(row.max, static_cast<double>(max[k]));
        row.speed = std::max(row.speed, static_cast<double>(speed[k]));
    }
    return end;
}

}  // namespace

void Meter::measure(const State& state, double dt, Pool& pool, Measures& out) {
    const Grid& grid = state.grid();
    const Boundary& boundary = state.boundary;
    if (!vorticity_.same_shape(state.density)) vorticity_ = boundary.field(Site::Centre);
    rows_.resize(static_cast<std::size_t>(grid.ny));
    vorticity(state.velocity, boundary, vorticity_, pool);

    pool.bands(grid.ny, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            rows_[j] = {};
            const std::uint8_t* solid = boundary.solids().data() + static_cast<std::ptrdiff_t>(j) * grid.nx;
            const bool clear =
                !boundary.has_solids() || std::all_of(solid, solid + grid.nx, std::logical_not{});
            const CellRow cells{state.density.row(j),    state.temperature.row(j),    state.velocity.u.row(j),
                                state.velocity.v.row(j), state.velocity.v.row(j + 1), vorticity_.row(j)};
            int i = clear ? add_vectors(cells, grid.nx, rows_[j]) : 0;
            for (; i < grid.nx; ++i) {
                if (solid[i] == 0) add_cell(cells, i, rows_[j]);
            }
        }
    });
    RowSums sum;
    for (const RowSums& row : rows_) {
        sum.density += row.density;
        sum.heat += row.heat;
        sum.energy += row.energy;
        sum.enstrophy += row.enstrophy;
        sum.min = std::min(sum.min, row.min);
        sum.max = std::max(sum.max, row.max);
        sum.speed = std::max(sum.speed, row.speed);
    }
    finite_ = std::isfinite(sum.density) && std::isfinite(sum.heat) && std::isfinite(sum.energy) &&
              std::isfinite(sum.enstrophy);
    out.step = state.step;
    out.time = state.time;
    out.density_percent = state.put_in > 0 ? 100 * sum.density * grid.cell() / state.put_in
                                           : std::numeric_limits<double>::quiet_NaN();
    out.kinetic_energy = sum.energy * grid.cell();
    out.enstrophy = sum.enstrophy * grid.cell();
    out.min_density = boundary.fluid_cells() > 0 ? sum.min : 0;
    out.max_density = boundary.fluid_cells() > 0 ? sum.max : 0;
    out.cfl = sum.speed * dt / grid.h;
}

std::string not_finite(const State& state) {
    const std::pair<const char*, const Field*> fields[] = {{"density", &state.density},
                                                           {"temperature", &state.temperature},
                                                           {"velocity u", &state.velocity.u},
                                                           {"velocity v", &state.velocity.v},
                                                           {"pressure", &state.pressure}};
    for (const auto& [name, field] : fields) {
        for (int j = 0; j < field->height(); ++j) {
            for (int i = 0; i < field->width(); ++i) {
                if (std::isfinite((*field)(i, j))) continue;
                return std::string(name) + " at (" + std::to_string(i) + ", " + std::to_string(j) + ")";
            }
        }
    }
    return {};
}

Errors errors(const Field& q, const Field& exact, const Grid& grid) {
    double sum = 0, squares = 0, worst = 0;
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) {
            const double e = std::abs(static_cast<double>(q(i, j)) - static_cast<double>(exact(i, j)));
            sum += e;
            squares += e * e;
            worst = std::max(worst, e);
        }
    }
    return {sum * grid.cell(), std::sqrt(squares * grid.cell()), worst};
}

}  // namespace whorl
