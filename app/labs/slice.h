// What a field is along a line through it.
#pragma once

#include <vector>

#include "app/labs/slice_line.h"
#include "core/grid/boundary.h"
#include "core/session/snapshot.h"

namespace whorl::app {

/// Samples along a line; NaN in solid cells.
struct SliceCurve {
    std::vector<float> x;  ///< along the line from its first end, length
    std::vector<float> y;  ///< unit of the field
};

/// The values of the cells whose centres lie along a horizontal or vertical line. An oblique one has none: it
/// meets few, and by chance.
/// @param field at the centres of `lane`
SliceCurve cells_along(const Field& field, const Snapshot& lane, const SliceLine& line);

/// What the solver's own interpolation makes of a field along the line. Where the line passes between two
/// rows or columns of centres, and the interpolation may have a kink, lies a sample.
/// @param field    at the centres of `lane`, ghosts filled
/// @param schemes  its interpolation, clamping and axis order are used
/// @param per_cell samples to a cell's length at least
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
        Field field;
        long version = -1;
    };
    std::vector<Filled> lanes_;
};

}  // namespace whorl::app
