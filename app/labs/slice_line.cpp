#include "app/labs/slice_line.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace whorl::app {
namespace {

glm::dvec2 shape(const Grid& grid) {
    return {grid.nx, grid.ny};
}

/// The row or column that holds a fraction of the domain.
int index_of(double fraction, int count) {
    return std::clamp(static_cast<int>(fraction * count), 0, count - 1);
}

/// Makes a line exactly horizontal or vertical where its moved end has come near to that.
void snap(glm::dvec2& moved, glm::dvec2 fixed, glm::dvec2 near) {
    const glm::dvec2 off = glm::abs(moved - fixed) / near;
    if (off.y <= 1 && off.y <= off.x) {
        moved.y = fixed.y;
    } else if (off.x <= 1) {
        moved.x = fixed.x;
    }
}

/// Keeps the moved end a cell from the other: in its direction, or in the one it had, or inwards where that
/// way leads out of the domain.
void keep_apart(glm::dvec2& moved, glm::dvec2 fixed, glm::dvec2 before, glm::dvec2 cells) {
    glm::dvec2 way = (moved - fixed) * cells;
    if (glm::length(way) >= 1) return;
    if (glm::length(way) == 0) way = (before - fixed) * cells;
    const glm::dvec2 step = glm::normalize(way) / cells;
    for (const int axis : {0, 1}) {
        const double there = fixed[axis] + step[axis];
        moved[axis] = there >= 0 && there <= 1 ? there : fixed[axis] - step[axis];
    }
}

/// Puts a horizontal or vertical line on centres of cells.
void settle(SliceLine& line, const Grid& grid) {
    if (line.horizontal()) line.from.y = line.to.y = (index_of(line.from.y, grid.ny) + 0.5) / grid.ny;
    if (line.vertical()) line.from.x = line.to.x = (index_of(line.from.x, grid.nx) + 0.5) / grid.nx;
}

}  // namespace

double GridLine::cells() const {
    return glm::length(to - from);
}

GridLine place_line(const SliceLine& line, const Grid& grid) {
    if (grid.dimensions() == 1) return {{-0.5, 0}, {grid.nx - 0.5, 0}, grid.h};
    GridLine placed{line.from * shape(grid) - 0.5, line.to * shape(grid) - 0.5, grid.h};
    if (line.horizontal()) placed.from.y = placed.to.y = index_of(line.from.y, grid.ny);
    if (line.vertical()) placed.from.x = placed.to.x = index_of(line.from.x, grid.nx);
    return placed;
}

SliceLine dragged(const SliceLine& line, SliceGrip grip, glm::dvec2 by, glm::dvec2 near, const Grid& grid) {
    SliceLine now = line;
    settle(now, grid);  // as it is drawn, lest its other end jump
    if (grip == SliceGrip::Whole) {
        by = glm::clamp(by, -glm::min(now.from, now.to), 1.0 - glm::max(now.from, now.to));
        now.from = glm::clamp(now.from + by, 0.0, 1.0);
        now.to = glm::clamp(now.to + by, 0.0, 1.0);
    } else {
        const bool first = grip == SliceGrip::From;
        glm::dvec2& moved = first ? now.from : now.to;
        const glm::dvec2 fixed = first ? now.to : now.from;
        const glm::dvec2 before = moved;
        moved = glm::clamp(before + by, 0.0, 1.0);
        snap(moved, fixed, near);
        keep_apart(moved, fixed, before, shape(grid));
    }
    settle(now, grid);
    return now;
}

}  // namespace whorl::app
