// See axes.h.
#include "app/plot/axes.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace whorl::app {
namespace {

/// Air between a curve's top and the frame's, as a part of the range.
constexpr double air = 0.06;

Interval around(double value, bool log_y) {
    if (log_y) return {value / 3.0, value * 3.0};
    if (value == 0.0) return {-1.0, 1.0};
    const double margin = 0.5 * std::abs(value);
    return value > 0.0 ? Interval{0.0, value + margin} : Interval{value - margin, 0.0};
}

}  // namespace

std::size_t Abscissa::nearest(double x, std::size_t n) const {
    if (plot_.x.empty()) {
        const double k = std::round((x - plot_.x_first) / plot_.x_stride);
        return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(n - 1)));
    }
    const auto samples = plot_.x.first(n);
    const auto above = std::lower_bound(samples.begin(), samples.end(), static_cast<float>(x));
    const auto k = static_cast<std::size_t>(above - samples.begin());
    if (k == n) return n - 1;
    if (k > 0 && x - at(k - 1) < at(k) - x) return k - 1;
    return k;
}

float Frame::to_x(double value) const {
    return low.x + static_cast<float>((value - x.lo) / (x.hi - x.lo)) * (high.x - low.x);
}

float Frame::to_y(double value) const {
    const double part =
        log_y ? std::log(value / y.lo) / std::log(y.hi / y.lo) : (value - y.lo) / (y.hi - y.lo);
    return high.y - static_cast<float>(part) * (high.y - low.y);
}

double Frame::from_x(float pixel) const {
    return x.lo + static_cast<double>((pixel - low.x) / (high.x - low.x)) * (x.hi - x.lo);
}

Interval fit_x(const Plot& plot, std::span<const Series> series) {
    const Abscissa abscissa(plot);
    std::size_t longest = 0;
    for (const Series& one : series) longest = std::max(longest, abscissa.count(one));
    if (longest == 0) return {plot.x_first, plot.x_first + plot.x_stride};
    const double lo = abscissa.at(0);
    const double hi = abscissa.at(longest - 1);
    return {lo, hi > lo ? hi : lo + plot.x_stride};
}

Interval fit_y(std::span<const std::vector<CurvePoint>> curves, bool log_y) {
    double lo = DBL_MAX;
    double hi = -DBL_MAX;
    for (const auto& curve : curves) {
        for (const CurvePoint& point : curve) {
            if (std::isnan(point.y)) continue;
            lo = std::min(lo, static_cast<double>(point.y));
            hi = std::max(hi, static_cast<double>(point.y));
        }
    }
    if (lo > hi) return log_y ? Interval{0.1, 1.0} : Interval{0.0, 1.0};
    const double largest = std::max(std::abs(lo), std::abs(hi));
    if (hi - lo <= 1e-6 * largest) return around(0.5 * (lo + hi), log_y);
    if (log_y) {
        const double factor = std::max(std::pow(hi / lo, air), 1.02);
        return {lo / factor, hi * factor};
    }
    // Zero belongs in the picture unless the curve stays far from it.
    if (lo > 0.0 && lo < 0.6 * hi) lo = 0.0;
    if (hi < 0.0 && hi > 0.6 * lo) hi = 0.0;
    const double margin = air * (hi - lo);
    return {lo == 0.0 ? lo : lo - margin, hi == 0.0 ? hi : hi + margin};
}

}  // namespace whorl::app
