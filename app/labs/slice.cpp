#include "app/labs/slice.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/labs/field_sampling.h"

namespace whorl::app {
namespace {

// Cells: farther than rounding, and far nearer than anyone sees.
constexpr double same_place = 1e-6;

struct Crossing {
    double along;   ///< cells from the line's first end
    glm::dvec2 at;  ///< in samples
};

/// The line's ends, and where it crosses rows and columns of centres, in order.
std::vector<Crossing> crossings(const GridLine& line) {
    const glm::dvec2 way = line.to - line.from;
    const double length = line.cells();
    std::vector<Crossing> found{{0, line.from}, {length, line.to}};
    for (const int axis : {0, 1}) {
        if (way[axis] == 0) continue;
        const auto [low, high] = std::minmax(line.from[axis], line.to[axis]);
        for (double sample = std::ceil(low); sample <= high; ++sample) {
            const double part = (sample - line.from[axis]) / way[axis];
            glm::dvec2 at = line.at(part);
            at[axis] = sample;
            found.push_back({part * length, at});
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Crossing& a, const Crossing& b) { return a.along < b.along; });
    const auto same = [](const Crossing& a, const Crossing& b) { return b.along - a.along < same_place; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

/// The cell that holds a point.
glm::ivec2 cell_at(const Grid& grid, glm::dvec2 at) {
    return glm::clamp(glm::ivec2(glm::floor(at + 0.5)), glm::ivec2(0), glm::ivec2(grid.nx - 1, grid.ny - 1));
}

bool solid(const Snapshot& lane, glm::ivec2 cell) {
    return lane.solids()[static_cast<std::size_t>(cell.y) * lane.grid().nx + cell.x] != 0;
}

}  // namespace

SliceCurve cells_along(const Field& field, const Snapshot& lane, const SliceLine& line) {
    SliceCurve curve;
    const GridLine placed = place_line(line, lane.grid());
    if (placed.from.x != placed.to.x && placed.from.y != placed.to.y) return curve;
    for (const Crossing& crossing : crossings(placed)) {
        const glm::ivec2 cell = cell_at(lane.grid(), crossing.at);
        if (glm::distance(glm::dvec2(cell), crossing.at) > same_place) continue;
        curve.x.push_back(static_cast<float>(crossing.along * lane.grid().h));
        curve.y.push_back(solid(lane, cell) ? NAN : static_cast<float>(field(cell.x, cell.y)));
    }
    return curve;
}

SliceCurve curve_along(const Field& field, const Snapshot& lane, const SliceLine& line,
                       const SchemeSet& schemes, int per_cell) {
    SliceCurve curve;
    std::vector<glm::dvec2> places;
    const auto add = [&](double along, glm::dvec2 at) {
        curve.x.push_back(static_cast<float>(along * lane.grid().h));
        places.push_back(at);
    };
    const std::vector<Crossing> all = crossings(place_line(line, lane.grid()));
    add(all.front().along, all.front().at);
    for (std::size_t k = 1; k < all.size(); ++k) {
        const Crossing& a = all[k - 1];
        const Crossing& b = all[k];
        const int count = static_cast<int>(std::ceil((b.along - a.along - same_place) * per_cell));
        for (int m = 1; m < count; ++m) {
            const double part = static_cast<double>(m) / count;
            add(a.along + part * (b.along - a.along), a.at + part * (b.at - a.at));
        }
        add(b.along, b.at);
    }
    curve.y.resize(places.size());
    sample_field(field, schemes, lane.state.boundary.wraps(), places, curve.y);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (solid(lane, cell_at(lane.grid(), places[k]))) curve.y[k] = NAN;
    }
    return curve;
}

const Field& FilledFields::of(std::size_t lane, const Snapshot& snapshot, const Field& field, long version) {
    if (lanes_.size() <= lane) lanes_.resize(lane + 1);
    auto& [filled, filled_version] = lanes_[lane];
    if (filled_version == version) return filled;
    filled_version = version;
    filled = field;
    snapshot.state.boundary.fill(filled);
    return filled;
}

}  // namespace whorl::app
