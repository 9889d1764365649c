#include "core/measure/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/measure/vorticity.h"

namespace whorl {

void Meter::measure(const State& state, double dt, Pool& pool, Measures& out) {
    const Grid& grid = state.grid();
    const Boundary& boundary = state.boundary;
    if (!vorticity_.same_shape(state.density)) vorticity_ = boundary.field(Site::Centre);
    rows_.resize(static_cast<std::size_t>(grid.ny));
    vorticity(state.velocity, boundary, vorticity_, pool);

    const bool solids = boundary.has_solids();
    pool.bands(grid.ny, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            Row row{
                0, 0, 0, 0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                0};
            const Real* density = state.density.row(j);
            const Real* heat = state.temperature.row(j);
            const Real* u = state.velocity.u.row(j);
            const Real* v = state.velocity.v.row(j);
            const Real* v_above = state.velocity.v.row(j + 1);
            const Real* w = vorticity_.row(j);
            for (int i = 0; i < grid.nx; ++i) {
                if (solids && boundary.solid(i, j)) continue;
                const double rho = static_cast<double>(density[i]);
                row.density += rho;
                row.heat += static_cast<double>(heat[i]);
                row.min = std::min(row.min, rho);
                row.max = std::max(row.max, rho);
                const double left = static_cast<double>(u[i]), right = static_cast<double>(u[i + 1]);
                const double low = static_cast<double>(v[i]), high = static_cast<double>(v_above[i]);
                // Each face belongs half to either cell.
                row.energy += 0.25 * (left * left + right * right + low * low + high * high);
                row.enstrophy += 0.5 * static_cast<double>(w[i]) * static_cast<double>(w[i]);
                row.speed =
                    std::max({row.speed, std::abs(left), std::abs(right), std::abs(low), std::abs(high)});
            }
            rows_[j] = row;
        }
    });
    Row sum{0, 0, 0, 0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
    for (const Row& row : rows_) {
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
