// A line through the domain with two ends that can be moved.
#pragma once

#include <glm/vec2.hpp>

#include "core/scene/state.h"

namespace whorl::app {

/// A straight line between two ends, each given as fractions of the domain's width and height from its lower
/// left corner, so that grids of any resolution share it.
struct SliceLine {
    glm::dvec2 from{0, 0.5}, to{1, 0.5};

    static SliceLine row(double y = 0.5) { return {{0, y}, {1, y}}; }
    static SliceLine column(double x = 0.5) { return {{x, 0}, {x, 1}}; }

    bool horizontal() const { return from.y == to.y; }
    bool vertical() const { return from.x == to.x; }
    bool operator==(const SliceLine&) const = default;
};

/// The same line in one grid.
struct GridLine {
    glm::dvec2 from, to;  ///< in samples from the centre of cell (0, 0)
    double h;             ///< cell size, length

    /// In cells.
    double cells() const;
    /// In length units.
    double length() const { return cells() * h; }
    /// The point at a part of the line, 0 to 1, in samples.
    glm::dvec2 at(double part) const { return from + part * (to - from); }
    /// The same, in length units from the domain's corner.
    WorldPoint world(double part) const { return {(at(part).x + 0.5) * h, (at(part).y + 0.5) * h}; }
};

/// ControlRects a line in a grid. A horizontal line runs through the centres of the row that holds it, a
/// vertical one through those of its column; in one dimension the line is the whole domain.
GridLine place_line(const SliceLine& line, const Grid& grid);

/// What of a line is taken hold of.
enum class SliceGrip { None, From, To, Whole };

/// The line after a part of it was dragged. It stays inside the domain and a cell long at least; an end that
/// comes near the other's height or place makes it horizontal or vertical, and then it runs through centres
/// of cells.
/// @param line  where the drag began
/// @param by    the pointer's way, in fractions of the domain
/// @param near  how near is near, in fractions of the domain
/// @param grid  whose cells count
SliceLine dragged(const SliceLine& line, SliceGrip grip, glm::dvec2 by, glm::dvec2 near, const Grid& grid);

}  // namespace whorl::app
