// The measures of all lanes as a table.
#pragma once

#include <string>
#include <vector>

#include "app/run/history.h"

namespace whorl::app {

/// A lane of the table.
struct CsvLane {
    std::string title;
    LaneHistory history;
};

/// `step,time,lane,title,…`: a row a step and lane, lanes one after the other, counted from 1. A value that
/// is not finite leaves its column empty.
std::string plots_csv(const std::vector<CsvLane>& lanes);

}  // namespace whorl::app
