#include "app/labs/interval_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/labs/field_sampling.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

/// Samples of an interval, both ends included; a multiple of 4 and 1, to have its quarters.
constexpr int samples = 257;
/// A sample is a weighted sum of four values: roundings of their size, several each.
constexpr double roundings = 16;

constexpr Sides row_sides = sides::box;

using Curve = std::array<float, samples>;

Curve sampled(const Field& row, Id<Interpolation> interpolation, bool clamped, int i) {
    SchemeSet schemes;
    schemes.interpolation = interpolation;
    schemes.clamped = clamped;
    std::array<glm::dvec2, samples> places;
    for (int k = 0; k < samples; ++k)
        places[static_cast<std::size_t>(k)] = {i + k / static_cast<double>(samples - 1), 0};
    places.back().x = from_the_left(places.back().x);
    Curve curve;
    sample_field(row, schemes, row_sides.wraps(), places, curve);
    return curve;
}

/// The slopes of the cubic with these values at 0, 1/4, 3/4 and 1: its Hermite form [T 3.12] solved for them.
struct EndSlopes {
    double left, right;
    EndSlopes(double q0, double quarter, double three_quarters, double q1) {
        const double a = 64 * quarter - 54 * q0 - 10 * q1;
        const double b = 64 * three_quarters - 10 * q0 - 54 * q1;
        left = (3 * a - b) / 24;
        right = (a - 3 * b) / 24;
    }
};

}  // namespace

std::string IntervalReport::verdict() const {
    if (leaves_range()) return figure(std::max(below, above), 3) + (below > above ? " below" : " above");
    return turned > 0 ? "turns by " + figure(turned, 3) : "monotone";
}

Field row_of(std::span<const float> values) {
    const Boundary domain({static_cast<int>(values.size()), 1, 1.0}, row_sides);
    Field row = domain.field(Site::Centre);
    for (std::size_t k = 0; k < values.size(); ++k) row(static_cast<int>(k), 0) = values[k];
    domain.fill(row);
    return row;
}

IntervalReport report_on(const Field& row, Id<Interpolation> interpolation, bool clamped, int i) {
    IntervalReport report;
    double size = 0;
    for (int k = i - 1; k <= i + 2; ++k) size = std::max(size, std::abs(static_cast<double>(row(k, 0))));
    const double rounding = roundings * static_cast<double>(std::numeric_limits<Real>::epsilon()) * size;
    const auto counted = [&](double amount) { return amount > rounding ? amount : 0.0; };

    const Curve free = sampled(row, interpolation, false, i);
    const auto at = [&](int quarters) { return static_cast<double>(free[quarters * (samples - 1) / 4]); };
    const double secant = at(4) - at(0);
    report.flat = std::abs(secant) <= rounding;
    if (!report.flat) {
        const EndSlopes slopes(at(0), at(1), at(3), at(4));
        report.alpha = slopes.left / secant;
        report.beta = slopes.right / secant;
    }

    const Curve curve = clamped ? sampled(row, interpolation, true, i) : free;
    const auto [low, high] =
        std::minmax({static_cast<double>(row(i, 0)), static_cast<double>(row(i + 1, 0))});
    const double sign = secant < 0 ? -1 : 1;
    double furthest = -std::numeric_limits<double>::infinity();
    // At its right end a clamped curve is the next interval's, which has another range.
    for (const float sample : std::span(curve).first(clamped ? samples - 1 : samples)) {
        const auto q = static_cast<double>(sample);
        report.below = std::max(report.below, low - q);
        report.above = std::max(report.above, q - high);
        furthest = std::max(furthest, sign * q);
        report.turned = std::max(report.turned, furthest - sign * q);
    }
    report.below = counted(report.below);
    report.above = counted(report.above);
    report.turned = counted(report.turned);
    return report;
}

}  // namespace whorl::app
