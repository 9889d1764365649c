// Rows of data that tell interpolations apart.
#pragma once

#include <span>
#include <string_view>

namespace whorl::app {

struct DataSet {
    std::string_view key;
    std::string_view label;
    std::string_view help;
    std::string_view source;
    std::span<const float> values;  ///< at 0, 1, 2 …
    int interval;                   ///< the telling one
};

/// All data sets; the first two are those of the thesis' Figure 3.5.
std::span<const DataSet> data_sets();

}  // namespace whorl::app
