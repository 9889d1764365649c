// A stretch of a drag, and the samples near it.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/grid/cell_range.h"
#include "core/grid/field.h"

namespace whorl {

/// From one point to another (length units) in one step, so that quick strokes leave a continuous trail.
struct Segment {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool operator==(const Segment&) const = default;
};

/// The distance of a point from a segment, length.
inline double distance(const Segment& s, WorldPoint p) {
    const double dx = s.x1 - s.x0;
    const double dy = s.y1 - s.y0;
    const double length2 = dx * dx + dy * dy;
    const double t =
        length2 > 0 ? std::clamp(((p.x - s.x0) * dx + (p.y - s.y0) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - s.x0 - t * dx, p.y - s.y0 - t * dy);
}

/// Calls `work(i, j, distance)` for the samples that are less than `radius` (length) from a segment.
template <class Work>
void for_samples_near(const Segment& s, double radius, const Field& field, const Grid& grid, Work&& work) {
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
            if (d < radius) work(i, j, d);
        }
    }
}

/// The cells that samples near a segment can belong to.
inline CellRange cells_near(const Segment& s, double radius, const Grid& grid) {
    return cells_in(grid, std::min(s.x0, s.x1) - radius, std::min(s.y0, s.y1) - radius,
                    std::max(s.x0, s.x1) + radius, std::max(s.y0, s.y1) + radius);
}

}  // namespace whorl
