#include "core/sources/obstacle_stroke.h"

#include <algorithm>

#include "core/scene/parameters.h"

namespace whorl {
namespace {

constexpr std::string_view numbers[] = {"x0", "y0", "x1", "y1", "radius"};

ObstacleStroke stroke_of(const Edit& edit, bool solid) {
    const std::vector<double>& n = edit.numbers;
    return {{n[0], n[1], n[2], n[3]}, n[4], solid};
}

void check(const Edit& edit) {
    parameter("brush.radius").check(edit.numbers[4]);
}

CellRange act(const ObstacleStroke& stroke, State& state, const Scene& scene) {
    const Grid& grid = state.grid();
    std::vector<std::uint8_t> mask = state.boundary.solids();
    const std::vector<double> before = totals(state);
    // Half a cell is the least brush that always meets a centre.
    const double radius = std::max(stroke.radius, 0.75 * grid.h);
    for_samples_near(stroke.along, radius, state.density(), grid, [&](int i, int j, double) {
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
    return cells_near(stroke.along, radius, grid);
}

}  // namespace

extern constinit const EditVerb build_verb{
    .info{"build", "Build", "", "Makes the cells near a segment solid."},
    .numbers = numbers,
    .changes_walls = true,
    .check = check,
    .apply = [](const Edit& e, State& state, const Scene& scene) {
        return act(stroke_of(e, true), state, scene);
    }};

extern constinit const EditVerb erase_verb{.info{"erase", "Erase", "", "Makes them fluid again."},
                                           .numbers = numbers,
                                           .changes_walls = true,
                                           .check = check,
                                           .apply = [](const Edit& e, State& state, const Scene& scene) {
                                               return act(stroke_of(e, false), state, scene);
                                           }};

ObstacleStroke::operator Edit() const {
    return {solid ? build_verb : erase_verb, {along.x0, along.y0, along.x1, along.y1, radius}};
}

}  // namespace whorl
