// See stacking.h.
#include "app/plot/stacking.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plot/axes.h"

namespace whorl::app {
namespace {

/// Air beyond the highest and lowest stack, as a part of the range.
constexpr double air = 0.06;

}  // namespace

bool Stacked::gap(std::size_t column) const {
    return std::isnan(values[column * parts]);
}

float Stacked::net(std::size_t column) const {
    float sum = 0.0f;
    for (std::size_t part = 0; part < parts; ++part) sum += value(column, part);
    return sum;
}

Interval Stacked::extent(std::size_t column, std::size_t part, bool above) const {
    Interval extent{0.0, 0.0};
    for (std::size_t k = 0; k <= part; ++k) {
        const auto own = static_cast<double>(value(column, k));
        extent.lo = extent.hi;
        if ((own > 0.0) == above) extent.hi += own;
    }
    return extent;
}

Stacked stack(const Plot& plot, std::span<const Series> parts, int columns) {
    Stacked stacked;
    stacked.parts = parts.size();
    if (parts.empty()) return stacked;
    std::size_t n = std::numeric_limits<std::size_t>::max();
    for (const Series& part : parts) n = std::min(n, Abscissa(plot, part).count());
    const Abscissa abscissa(plot, parts.front());
    const auto wide = static_cast<std::size_t>(std::max(columns, 1));
    // Whole samples a column: columns then stay where they are while a series grows.
    const std::size_t group = std::max<std::size_t>(1, (n + wide - 1) / wide);
    std::vector<double> sums(parts.size());
    for (std::size_t start = 0; start < n; start += group) {
        const std::size_t end = std::min(start + group, n);
        std::fill(sums.begin(), sums.end(), 0.0);
        double taken = 0.0;
        for (std::size_t k = start; k < end; ++k) {
            const bool whole = std::all_of(parts.begin(), parts.end(),
                                           [&](const Series& part) { return std::isfinite(part.y[k]); });
            if (!whole) continue;
            taken += 1.0;
            for (std::size_t p = 0; p < parts.size(); ++p) sums[p] += static_cast<double>(parts[p].y[k]);
        }
        stacked.x.push_back(0.5 * (abscissa.at(start) + abscissa.at(end - 1)));
        // Nothing taken is 0 / 0: a gap.
        for (const double sum : sums) stacked.values.push_back(static_cast<float>(sum / taken));
    }
    return stacked;
}

Interval fit_stack(const Stacked& stacked) {
    double lo = 0.0;
    double hi = 0.0;
    for (std::size_t column = 0; column < stacked.columns(); ++column) {
        if (stacked.gap(column)) continue;
        lo = std::min(lo, stacked.extent(column, stacked.parts - 1, false).hi);
        hi = std::max(hi, stacked.extent(column, stacked.parts - 1, true).hi);
    }
    if (lo == hi) return {-1.0, 1.0};
    const double margin = air * (hi - lo);
    return {lo < 0.0 ? lo - margin : lo, hi > 0.0 ? hi + margin : hi};
}

}  // namespace whorl::app
