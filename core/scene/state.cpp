#include "core/scene/state.h"

#include <algorithm>
#include <cmath>

#include "core/sampling/cell.h"

namespace whorl {
namespace {

bool inside(const Obstacle& o, WorldPoint p) {
    if (o.radius > 0) return std::hypot(p.x - o.x, p.y - o.y) < o.radius;
    return std::abs(p.x - o.x) < o.width / 2 && std::abs(p.y - o.y) < o.height / 2;
}

std::vector<std::uint8_t> solids_of(const Scene& scene, const Grid& grid) {
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.nx) * grid.ny, 0);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const WorldPoint centre{(i + 0.5) * grid.h, (j + 0.5) * grid.h};
            const bool solid = std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                                           [&](const Obstacle& o) { return inside(o, centre); });
            mask[static_cast<std::size_t>(j) * grid.nx + i] = solid ? 1 : 0;
        }
    }
    return mask;
}

State still_air(const Scene& scene) {
    State state;
    state.boundary = Boundary(scene.grid(), scene.sides);
    state.scalars.resize(scalar_count());
    state.injected.assign(scalar_count(), 0.0);
    for_each_field(state, [&](FieldId id, Field& field) {
        field = state.boundary.field(id.info().site, ambient_value(id, scene));
    });
    return state;
}

void resample_field(const Field& from, const Boundary& boundary, Field& to, const Grid& grid) {
    write_samples(to, grid, [&](WorldPoint at) { return value_at(from, boundary, at); });
}

}  // namespace

Field& Fields::operator[](FieldId id) {
    if (id == field::u) return velocity.u;
    if (id == field::v) return velocity.v;
    if (id == field::pressure) return pressure;
    return scalars[scalar_index(id)];
}

Real ambient_value(FieldId id, const Scene& scene) {
    const auto ambient = id.info().ambient;
    return ambient == nullptr ? Real(0) : static_cast<Real>(ambient(scene));
}

std::vector<double> totals(const State& state) {
    std::vector<double> all(state.scalars.size(), 0.0);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (scalar(k).info().counted) all[k] = total(state.scalars[k], state.boundary);
    }
    return all;
}

Boundary boundary_of(const Scene& scene) {
    Boundary boundary(scene.grid(), scene.sides);
    if (!scene.obstacles.empty()) boundary.set_solids(solids_of(scene, boundary.grid()));
    return boundary;
}

State make_state(const Scene& scene) {
    State state = still_air(scene);
    state.boundary = boundary_of(scene);
    state.boundary.enforce(state.velocity);
    state.fill_ghosts();
    return state;
}

double total(const Field& field, const Boundary& boundary) {
    double sum = 0;
    for (int j = 0; j < field.height(); ++j) {
        double row = 0;
        for (int i = 0; i < field.width(); ++i) {
            if (!boundary.has_solids() || !boundary.solid(i, j)) row += static_cast<double>(field(i, j));
        }
        sum += row;
    }
    return sum * boundary.grid().cell();
}

Real value_at(const Field& field, const Boundary& boundary, WorldPoint at) {
    const double h = boundary.grid().h;
    const auto place = [&](double p, double offset, int n, bool wraps) {
        double x = p / h - offset;
        if (wraps) {
            x -= n * std::floor(x / n);
        } else {
            x = std::clamp(x, 0.0, static_cast<double>(n - 1));
        }
        const int i = std::min(static_cast<int>(x), n - 1);
        return std::pair{i, static_cast<Real>(x - i)};
    };
    const auto [i, x] = place(at.x, offset_x(field.site()), field.width(), boundary.wraps().x);
    const auto [j, y] = place(at.y, offset_y(field.site()), field.height(), boundary.wraps().y);
    return lerp(lerp(field(i, j), field(i + 1, j), x), lerp(field(i, j + 1), field(i + 1, j + 1), x), y);
}

State resample(const State& from, const Scene& scene) {
    State to = still_air(scene);
    const Grid& grid = to.grid();
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.nx) * grid.ny, 0);
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i) {
            const int from_i =
                std::min(static_cast<int>((i + 0.5) * grid.h / from.grid().h), from.grid().nx - 1);
            const int from_j =
                std::min(static_cast<int>((j + 0.5) * grid.h / from.grid().h), from.grid().ny - 1);
            mask[static_cast<std::size_t>(j) * grid.nx + i] = from.boundary.solid(from_i, from_j) ? 1 : 0;
        }
    }
    to.boundary.set_solids(std::move(mask));
    for_each_field(to,
                   [&](FieldId id, Field& field) { resample_field(from[id], from.boundary, field, grid); });
    to.boundary.enforce(to.velocity);
    to.fill_ghosts();
    to.step = from.step;
    to.time = from.time;
    const std::vector<double> before = totals(from), after = totals(to);
    for (std::size_t k = 0; k < after.size(); ++k) to.injected[k] = from.injected[k] + after[k] - before[k];
    return to;
}

}  // namespace whorl
