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

/// Place in an interval, 0 at its start and 1 at its end.
double part_of(double value, const Interval& range, bool logarithmic) {
    return logarithmic ? std::log(value / range.lo) / std::log(range.hi / range.lo)
                       : (value - range.lo) / (range.hi - range.lo);
}

}  // namespace

std::size_t Abscissa::nearest(double x) const {
    if (x_.empty()) {
        const double k = std::round((x - first_) / stride_);
        return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(count_ - 1)));
    }
    const auto samples = x_.first(count_);
    const auto above = std::lower_bound(samples.begin(), samples.end(), static_cast<float>(x));
    const auto k = static_cast<std::size_t>(above - samples.begin());
    if (k == count_) return count_ - 1;
    if (k > 0 && x - at(k - 1) < at(k) - x) return k - 1;
    return k;
}

float Frame::to_x(double value) const {
    return low.x + static_cast<float>(part_of(value, x, log_x)) * (high.x - low.x);
}

float Frame::to_y(double value) const {
    return high.y - static_cast<float>(part_of(value, y, log_y)) * (high.y - low.y);
}

double Frame::from_x(float pixel) const {
    const auto part = static_cast<double>((pixel - low.x) / (high.x - low.x));
    return log_x ? x.lo * std::pow(x.hi / x.lo, part) : x.lo + part * (x.hi - x.lo);
}

Interval fit_x(const Plot& plot, std::span<const Series> series) {
    double lo = DBL_MAX;
    double hi = -DBL_MAX;
    for (const Series& one : series) {
        const Abscissa abscissa(plot, one);
        std::size_t first = 0;
        while (plot.log_x && first < abscissa.count() && !(abscissa.at(first) > 0.0)) ++first;
        if (first == abscissa.count()) continue;
        lo = std::min(lo, abscissa.at(first));
        hi = std::max(hi, abscissa.at(abscissa.count() - 1));
    }
    if (lo > hi)
        return plot.log_x ? Interval{1.0, 10.0} : Interval{plot.x_first, plot.x_first + plot.x_stride};
    return {lo, hi > lo ? hi : lo + plot.x_stride};
}

double nearest_sample(const Plot& plot, std::span<const Series> series, double x) {
    double best = 0.0;
    double distance = DBL_MAX;
    for (const Series& one : series) {
        const Abscissa abscissa(plot, one);
        if (abscissa.count() == 0) continue;
        const double at = abscissa.at(abscissa.nearest(x));
        if (std::abs(at - x) < distance) {
            best = at;
            distance = std::abs(at - x);
        }
    }
    return best;
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
