// See ticks.h.
#include "app/plot/ticks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/number.h"

namespace whorl::app {
namespace {

/// Ticks that miss the range's ends by rounding alone still count, as a part of a step.
/// Ranges come in single precision.
constexpr double slack = 1e-6;

double round_step(double rough) {
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double part = rough / power;
    return power * (part < 1.5 ? 1.0 : part < 3.5 ? 2.0 : part < 7.5 ? 5.0 : 10.0);
}

std::string print(const char* format, int precision, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, precision, value);
    return text;
}

}  // namespace

Ticks linear_ticks(double lo, double hi, int target) {
    Ticks ticks;
    if (!std::isfinite(lo) || !std::isfinite(hi) || !(lo < hi) || target < 1) return ticks;
    const double step = round_step((hi - lo) / target);
    if (!(step > 0.0) || !std::isfinite(step)) return ticks;
    const double first = std::ceil(lo / step - slack);
    const double last = std::floor(hi / step + slack);
    // Beyond this, neighbouring ticks are the same number.
    if (!(std::abs(first) < 1e15 && std::abs(last) < 1e15)) return ticks;
    ticks.step = step;
    for (double k = first; k <= last; k += 1.0) ticks.values.push_back(k == 0.0 ? 0.0 : k * step);
    return ticks;
}

Ticks log_ticks(double lo, double hi, int target) {
    Ticks ticks;
    if (!(lo > 0.0) || !std::isfinite(hi) || !(lo < hi) || target < 1) return ticks;
    const double decades = std::log10(hi / lo);
    const double first = std::floor(std::log10(lo));
    const double last = std::ceil(std::log10(hi));
    const int stride = std::max(1, static_cast<int>(std::ceil(decades / target - slack)));
    for (double power = first; power <= last; power += 1.0) {
        const bool kept = std::fmod(std::abs(power), stride) == 0.0;
        for (const double part : {1.0, 2.0, 5.0}) {
            const double value = part * std::pow(10.0, power);
            const bool inside = value >= lo * (1.0 - slack) && value <= hi * (1.0 + slack);
            if (inside && (part == 1.0 ? kept : decades < 2.0)) ticks.values.push_back(value);
        }
    }
    return ticks;
}

std::string tick_label(double value, const Ticks& ticks) {
    if (value == 0.0) value = 0.0;  // no minus
    if (ticks.step == 0.0) {
        const bool plain = value > 0.009 && value < 99999.0;
        return plain ? print("%.*g", 5, value) : short_exponent(print("%.*e", 0, value));
    }
    const double largest = std::max(std::abs(ticks.values.front()), std::abs(ticks.values.back()));
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(ticks.step) + slack)));
    if (largest < 1e6 && decimals <= 4) return print("%.*f", decimals, value);
    if (value == 0.0) return "0";
    const double digits = std::floor(std::log10(largest)) - std::floor(std::log10(ticks.step) + slack);
    return short_exponent(print("%.*e", std::clamp(static_cast<int>(digits), 0, 9), value));
}

}  // namespace whorl::app
