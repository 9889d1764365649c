#include "core/forces/brush.h"

#include <algorithm>
#include <cmath>

namespace whorl {
namespace {

double distance(const Segment& s, WorldPoint p) {
    const double dx = s.x1 - s.x0;
    const double dy = s.y1 - s.y0;
    const double length2 = dx * dx + dy * dy;
    const double t =
        length2 > 0 ? std::clamp(((p.x - s.x0) * dx + (p.y - s.y0) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - s.x0 - t * dx, p.y - s.y0 - t * dy);
}

/// 1 on the line, 0 at the radius, smooth at both ends.
double falloff(double distance, double radius) {
    const double s = std::min(distance / radius, 1.0);
    return (1 - s * s) * (1 - s * s);
}

/// Calls `work(i, j, share)` for the samples within a stroke's radius.
template <class Work>
void for_samples(const Field& field, const Grid& grid, const Segment& s, double radius, Work&& work) {
    const auto range = [&](double low, double high, double offset, int n) {
        return std::pair{
            std::clamp(static_cast<int>(std::floor((low - radius) / grid.h - offset)), 0, n),
            std::clamp(static_cast<int>(std::ceil((high + radius) / grid.h - offset)) + 1, 0, n)};
    };
    const auto [i0, i1] =
        range(std::min(s.x0, s.x1), std::max(s.x0, s.x1), offset_x(field.site()), field.width());
    const auto [j0, j1] =
        range(std::min(s.y0, s.y1), std::max(s.y0, s.y1), offset_y(field.site()), field.height());
    for (int j = j0; j < j1; ++j) {
        for (int i = i0; i < i1; ++i) {
            const double d = distance(s, world(field, grid, i, j));
            if (d < radius) work(i, j, falloff(d, radius));
        }
    }
}

void drag(Field& field, const State& state, const SmokeStroke& stroke, double velocity) {
    for_samples(field, state.grid(), stroke.along, stroke.radius, [&](int i, int j, double share) {
        const double take = std::min(1.0, stroke.push * share);
        field(i, j) += static_cast<Real>(take * (stroke.push * velocity - static_cast<double>(field(i, j))));
    });
}

void bring(FieldId id, State& state, const SmokeStroke& stroke) {
    Field& field = state[id];
    const double amount = stroke.amounts[id];
    const bool raises = id.info().source->stroke == Source::Stroke::Raise;
    double change = 0;
    for_samples(field, state.grid(), stroke.along, stroke.radius, [&](int i, int j, double share) {
        if (state.boundary.solid(i, j)) return;
        const Real value = field(i, j);
        const double before = static_cast<double>(value);
        if (raises) {
            const double after = std::max(before, amount * share);
            change += after - before;
            field(i, j) = static_cast<Real>(after);
        } else {
            const Real step = static_cast<Real>(share * (amount - before));
            change += static_cast<double>(step);
            field(i, j) = value + step;
        }
    });
    if (id.info().counted) state.injected[scalar_index(id)] += change * state.grid().cell();
}

}  // namespace

void apply(const SmokeStroke& stroke, State& state) {
    if (stroke.smoke) {
        for_sources([&](FieldId id) { bring(id, state, stroke); });
    }
    if (stroke.push > 0 && (stroke.velocity_x != 0 || stroke.velocity_y != 0)) {
        drag(state.velocity.u, state, stroke, stroke.velocity_x);
        drag(state.velocity.v, state, stroke, stroke.velocity_y);
        state.boundary.enforce(state.velocity);
    }
    state.fill_ghosts();
}

void apply(const ObstacleStroke& stroke, State& state, const Scene& scene) {
    const Grid& grid = state.grid();
    std::vector<std::uint8_t> mask = state.boundary.solids();
    const std::vector<double> before = totals(state);
    // Half a cell is the least brush that always meets a centre.
    const double radius = std::max(stroke.radius, 0.75 * grid.h);
    for_samples(state.density(), grid, stroke.along, radius, [&](int i, int j, double) {
        std::uint8_t& cell = mask[static_cast<std::size_t>(j) * grid.nx + i];
        if (cell != 0 && !stroke.solid) {
            for (std::size_t k = 0; k < state.scalars.size(); ++k)
                state.scalars[k](i, j) = ambient_value(scalar(k), scene);
        }
        cell = stroke.solid ? 1 : 0;
    });
    state.boundary.set_solids(std::move(mask));
    state.boundary.enforce(state.velocity);
    state.fill_ghosts();
    const std::vector<double> after = totals(state);
    for (std::size_t k = 0; k < after.size(); ++k) state.injected[k] += after[k] - before[k];
}

}  // namespace whorl
