// See decimate.h.
#include "app/plot/decimate.h"

#include <algorithm>
#include <cfloat>
#include <limits>

namespace whorl::app {

void decimate(std::span<const float> y, int columns, bool positive, std::vector<CurvePoint>& out) {
    out.clear();
    const std::size_t n = y.size();
    const auto wide = static_cast<std::size_t>(std::max(columns, 1));
    // Whole samples a column: columns then stay where they are while a series grows.
    const std::size_t group = (n + wide - 1) / wide;
    // Not the least denormal: where denormals are flushed, as beside a solver, 0 is not below that.
    const float floor = positive ? FLT_MIN : -FLT_MAX;
    const auto gap = [&](std::size_t k) { out.push_back({k, std::numeric_limits<float>::quiet_NaN()}); };

    for (std::size_t start = 0; start < n; start += group) {
        const std::size_t end = std::min(start + group, n);
        CurvePoint least{end, FLT_MAX};
        CurvePoint greatest{end, -FLT_MAX};
        bool whole = true;
        for (std::size_t k = start; k < end; ++k) {
            const float value = y[k];
            if (!(value >= floor && value <= FLT_MAX)) {
                whole = false;
                continue;
            }
            if (value < least.y || least.index == end) least = {k, value};
            if (value > greatest.y || greatest.index == end) greatest = {k, value};
        }
        if (least.index != end) {
            out.push_back(least.index < greatest.index ? least : greatest);
            if (least.index != greatest.index) out.push_back(least.index < greatest.index ? greatest : least);
        }
        if (!whole) gap(start);
    }
}

}  // namespace whorl::app
