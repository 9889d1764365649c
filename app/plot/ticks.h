// Round numbers along an axis, and how they are written.
#pragma once

#include <string>
#include <vector>

namespace whorl::app {

/// Values to mark on an axis, ascending, and what tells their labels apart.
struct Ticks {
    std::vector<double> values;
    double step = 0.0;  ///< distance between neighbours; 0 on a logarithmic axis
};

/// Multiples of 1, 2 or 5 times a power of ten inside [lo, hi], about `target` of them and never twice as
/// many. Empty if the range is empty or not finite.
Ticks linear_ticks(double lo, double hi, int target);

/// Powers of ten inside [lo, hi], thinned to about `target`; with less than two decades, 1, 2 and 5 of each.
/// Empty unless 0 < lo < hi.
Ticks log_ticks(double lo, double hi, int target);

/// A tick's number: as many decimals as its step needs, or like 2.5e-7 where that gets long.
std::string tick_label(double value, const Ticks& ticks);

}  // namespace whorl::app
