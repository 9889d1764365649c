// A line through the domain, and what a field is along it.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/grid/boundary.h"
#include "core/session/snapshot.h"

namespace whorl::app {

/// A row or a column of cells: the one that holds `place`, a part of the domain's height or width.
struct SliceLine {
    bool vertical = false;
    double place = 0.5;  ///< 0 to 1

    /// The row or column in a grid.
    int index(const Grid& grid) const;
    /// Number of cells along it.
    int count(const Grid& grid) const { return vertical ? grid.ny : grid.nx; }
    bool operator==(const SliceLine&) const = default;
};

/// Samples along a line; NaN in solid cells.
struct SliceCurve {
    std::vector<float> x;  ///< from the domain's edge, length
    std::vector<float> y;  ///< unit of the field
};

/// The values of the line's cells at their centres.
/// @param field at the centres of `lane`
SliceCurve cells_along(const Field& field, const Snapshot& lane, const SliceLine& line);

/// What the solver's own interpolation makes of a field between the line's cells, `per_cell` samples each.
/// @param field   at the centres of `lane`, ghosts filled
/// @param schemes its interpolation, clamping and axis order are used
SliceCurve curve_along(const Field& field, const Snapshot& lane, const SliceLine& line,
                       const SchemeSet& schemes, int per_cell);

/// The lanes' fields with their ghosts, which snapshots hold without.
class FilledFields {
  public:
    /// A lane's field with its ghosts filled. Valid until the next call for this lane.
    /// @param version  of the field: nothing is done where it is that of the last call
    const Field& of(std::size_t lane, const Snapshot& snapshot, const Field& field, long version);

  private:
    struct Filled {
        Boundary domain;
        Field field;
        long version = -1;
    };
    std::vector<Filled> lanes_;
};

}  // namespace whorl::app
