#include "core/measure/measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/parallel/row_bands.h"
#include "core/parallel/simd.h"

namespace whorl {
namespace {

/// The samples in and around a row of cells.
struct CellRow {
    const Real* density;
    const Real* temperature;
    const Real* u;
    const Real* v;
    const Real* v_above;
};

void add_cell(const CellRow& cells, int i, RowSums& row) {
    const auto at = [i](const Real* samples) { return static_cast<double>(samples[i]); };
    const double rho = at(cells.density);
    const double left = at(cells.u), right = at(cells.u + 1), low = at(cells.v), high = at(cells.v_above);
    row.density += rho;
    row.temperature += at(cells.temperature);
    row.min = std::min(row.min, rho);
    row.max = std::max(row.max, rho);
    row.speed = std::max({row.speed, std::abs(left), std::abs(right), std::abs(low), std::abs(high)});
}

/// The same for as many cells as fill whole vectors, four sums side by side. @return how many
int add_vectors(const CellRow& cells, int count, RowSums& row) {
    using T = RealVector<16>;
    constexpr int lanes = vector_width<T>;
    using Wide __attribute__((vector_size(lanes * sizeof(double)))) = double;
    const int end = count - count % lanes;
    if (end == 0) return 0;
    Wide density{}, temperature{};
    T min = load<T>(cells.density), max = min, speed{};
    for (int i = 0; i < end; i += lanes) {
        const T rho = load<T>(cells.density + i);
        min = smaller(rho, min);
        max = larger(rho, max);
        density += __builtin_convertvector(rho, Wide);
        temperature += __builtin_convertvector(load<T>(cells.temperature + i), Wide);
        for (const Real* face : {cells.u, cells.u + 1, cells.v, cells.v_above}) {
            const T velocity = load<T>(face + i);
            speed = larger(larger(velocity, -velocity), speed);
        }
    }
    for (int k = 0; k < lanes; ++k) {
        row.density += density[k];
        row.temperature += temperature[k];
        row.min = std::min(row.min, static_cast<double>(min[k]));
        row.max = std::max(row.max, static_cast<double>(max[k]));
        row.speed = std::max(row.speed, static_cast<double>(speed[k]));
    }
    return end;
}

}  // namespace

PhaseShare Measures::phase(std::string_view key) const {
    const auto found =
        std::find_if(phases.begin(), phases.end(), [&](const auto& p) { return p.first == key; });
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return found != phases.end() ? found->second : PhaseShare{unknown, unknown, unknown};
}

void Measures::add(std::string_view phase, const PhaseShare& did) {
    auto found = std::find_if(phases.begin(), phases.end(), [&](const auto& p) { return p.first == phase; });
    if (found == phases.end()) found = phases.insert(phases.end(), {phase, {}});
    found->second.ms += did.ms;
    found->second.energy += did.energy;
    found->second.enstrophy += did.enstrophy;
}

void StateReducer::measure(const State& state, const FlowSums& flow, double dt, Pool& pool, Measures& out) {
    const Grid& grid = state.grid();
    const Boundary& boundary = state.boundary;
    rows_.resize(static_cast<std::size_t>(grid.ny));
    row_bands(pool, grid.nx, grid.ny, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            rows_[j] = {};
            const std::uint8_t* solid = boundary.solids().data() + static_cast<std::ptrdiff_t>(j) * grid.nx;
            const bool clear =
                !boundary.has_solids() || std::all_of(solid, solid + grid.nx, std::logical_not{});
            const CellRow cells{state.density().row(j), state.temperature().row(j), state.velocity.u.row(j),
                                state.velocity.v.row(j), state.velocity.v.row(j + 1)};
            int i = clear ? add_vectors(cells, grid.nx, rows_[j]) : 0;
            for (; i < grid.nx; ++i) {
                if (solid[i] == 0) add_cell(cells, i, rows_[j]);
            }
        }
    });
    RowSums sum;
    for (const RowSums& row : rows_) {
        sum.density += row.density;
        sum.temperature += row.temperature;
        sum.min = std::min(sum.min, row.min);
        sum.max = std::max(sum.max, row.max);
        sum.speed = std::max(sum.speed, row.speed);
    }
    finite_ = std::isfinite(flow.kinetic_energy) && std::isfinite(flow.enstrophy);
    out.percent.resize(state.scalars.size());
    for (std::size_t k = 0; k < state.scalars.size(); ++k) {
        const double in_all = k == 0   ? sum.density * grid.cell()
                              : k == 1 ? sum.temperature * grid.cell()
                                       : total(state.scalars[k], boundary);
        finite_ = finite_ && std::isfinite(in_all);
        out.percent[k] = state.injected[k] > 0 ? 100 * in_all / state.injected[k]
                                               : std::numeric_limits<double>::quiet_NaN();
    }
    out.step = state.step;
    out.time = state.time;
    out.kinetic_energy = flow.kinetic_energy;
    out.enstrophy = flow.enstrophy;
    out.min_density = boundary.fluid_cells() > 0 ? sum.min : 0;
    out.max_density = boundary.fluid_cells() > 0 ? sum.max : 0;
    out.cfl = sum.speed * dt / grid.h;
}

std::string not_finite(const State& state) {
    std::string first;
    for_each_field(state, [&](FieldId id, const Field& field) {
        for (int j = 0; j < field.height() && first.empty(); ++j) {
            for (int i = 0; i < field.width() && first.empty(); ++i) {
                if (!std::isfinite(field(i, j)))
                    first = std::string(id.info().title) + " at (" + std::to_string(i) + ", " +
                            std::to_string(j) + ")";
            }
        }
    });
    return first;
}

double effective_viscosity(double energy_change, double enstrophy, double dt) {
    if (enstrophy == 0) return std::numeric_limits<double>::quiet_NaN();
    return -energy_change / (dt * 2 * enstrophy);
}

Errors errors(const Field& q, const Field& reference, const Boundary& boundary) {
    const Grid& grid = boundary.grid();
    double sum = 0, squares = 0, worst = 0;
    for (int j = 0; j < q.height(); ++j) {
        for (int i = 0; i < q.width(); ++i) {
            if (boundary.has_solids() && boundary.solid(i, j)) continue;
            const double e = std::abs(static_cast<double>(q(i, j)) - static_cast<double>(reference(i, j)));
            sum += e;
            squares += e * e;
            worst = std::max(worst, e);
        }
    }
    return {sum * grid.cell(), std::sqrt(squares * grid.cell()), worst};
}

}  // namespace whorl
