// Which measures share a plot.
#pragma once

#include <string>
#include <vector>

#include "core/measure/measure.h"

namespace whorl::app {

/// A plot: several curves of one lane, or one curve of each of several lanes.
struct Chart {
    std::string key, title;
    std::vector<const Measure*> curves;  ///< by colour; one or more

    const Measure& first() const { return *curves.front(); }
    std::string unit() const { return first().plot.unit ? first().unit : std::string(); }
    Scale scale() const { return first().plot.scale; }
    Needs needs() const { return first().needs; }
};

/// The charts of a page, from top to bottom, for one lane.
std::vector<Chart> charts_of(Page page);

/// The same for several lanes, where each chart has one measure.
/// @param norm  the error that lanes are compared by
std::vector<Chart> lanes_charts_of(Page page, const Measure& norm);

}  // namespace whorl::app
