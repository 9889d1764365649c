// Signed contributions on top of each other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "app/plot/plot.h"

namespace whorl::app {

/// Contributions averaged over columns, so that their sum and what lies under them stay what they were.
struct Stacked {
    std::size_t parts = 0;
    std::vector<double> x;      ///< middle of each column
    std::vector<float> values;  ///< parts of the first column, parts of the second …; NaN in a gap

    std::size_t columns() const { return x.size(); }
    bool gap(std::size_t column) const;
    float value(std::size_t column, std::size_t part) const { return values[column * parts + part]; }
    /// Sum of the column's parts.
    float net(std::size_t column) const;
    /// Where a part begins and ends above 0, or below: it lies on the parts of that sign before it, away from
    /// 0, and is flat where it has the other sign.
    Interval extent(std::size_t column, std::size_t part, bool above) const;
};

/// Averages the samples that all parts have into at most `columns` columns. A sample that is NaN or infinite
/// in any part counts for none; a column of only such samples is a gap.
Stacked stack(const Plot& plot, std::span<const Series> parts, int columns);

/// A y interval around all of it, with 0 inside and some air, never empty.
Interval fit_stack(const Stacked& stacked);

}  // namespace whorl::app
