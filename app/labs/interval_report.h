// What an interpolation does in one interval of a row of data.
#pragma once

#include <span>
#include <string>

#include "core/grid/boundary.h"
#include "core/interpolation/interpolation.h"

namespace whorl::app {

/// The curve between points i and i + 1.
struct IntervalReport {
    bool flat = false;           ///< its ends are equal: there are no slopes over the secant
    double alpha = 0, beta = 0;  ///< slopes at its ends over its own secant, before clamping  [T 3.16–3.17]
    double below = 0, above = 0;  ///< how far it leaves the range of points i and i + 1, unit of the data
    double turned = 0;            ///< how far it goes against its own direction, unit of the data

    /// "0.12 below", "0.12 above", "turns by 0.12" or "monotone".
    std::string verdict() const;
    bool leaves_range() const { return below > 0 || above > 0; }
};

/// A row of samples between two walls, ghosts filled.
Field row_of(std::span<const float> values);

/// Asks the solver's interpolation; what rounding alone explains counts for nothing.
/// @param row  as row_of makes it
/// @param i    0 … row.width() − 2
IntervalReport report_on(const Field& row, Id<Interpolation> interpolation, bool clamped, int i);

}  // namespace whorl::app
