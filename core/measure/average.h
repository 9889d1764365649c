// A field of one resolution at another: what a fine reference run says on a coarse lane's cells.
#pragma once

#include <vector>

#include "core/grid/boundary.h"

namespace whorl {

/// The cells of a fine axis that meet one cell of a coarse one, and their shares of it, which add up to 1.
struct Overlap {
    int first, last;  ///< both inclusive
    double first_share, inner_share, last_share;
};

/// Brings fields at centres to other grids of the same domain; keeps its scratch from call to call, so that
/// one with the shapes of the last allocates nothing.
class Averager {
  public:
    /// Where `from` is as fine as `to` or finer along both axes: means of the cells of `from`, weighted by
    /// the area that they share with a cell of `to`. ∫q stays what it is, to rounding; equal grids copy bits.
    /// Elsewhere: bilinear sampling, as in a change of grid, which does not keep ∫q.
    /// Solid cells count as all others do, with the value of the nearest fluid cell that Boundary::fill gave
    /// them.
    /// @param q    at centres of `from`, ghosts filled
    /// @param from the domain of q; as wide and high as `to` is
    /// @param out  at centres of `to`, distinct storage; its ghosts are not written
    void average(const Field& q, const Boundary& from, const Grid& to, Field& out);

  private:
    void average_down(const Field& q, const Grid& from, const Grid& to, Field& out);

    std::vector<Overlap> columns_;
    std::vector<double> row_, sum_;
};

}  // namespace whorl
