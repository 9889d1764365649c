#include "app/run/colour_range.h"

#include <cmath>

namespace whorl::app {
namespace {

// A field that grows is followed at once, so that little saturates; one that fades is let go slowly.
constexpr double rise_seconds = 0.1;
constexpr double fall_seconds = 2.5;

}  // namespace

void ColourRange::set(Range ends) {
    if (!(ends.lo < ends.hi) || !std::isfinite(ends.lo) || !std::isfinite(ends.hi)) return;
    ends_ = ends;
    held_ = true;
}

void ColourRange::follow(const View& view, bool difference, Range span, double seconds) {
    const bool another = view_ != &view || difference_ != difference;
    view_ = &view;
    difference_ = difference;
    if (another) {
        held_ = false;
        ends_ = span;
    }
    if (held_ || !std::isfinite(span.lo) || !std::isfinite(span.hi)) return;
    const bool grows = span.hi - span.lo > ends_.hi - ends_.lo;
    const auto share = static_cast<float>(1 - std::exp(-seconds / (grows ? rise_seconds : fall_seconds)));
    ends_.lo += share * (span.lo - ends_.lo);
    ends_.hi += share * (span.hi - ends_.hi);
}

}  // namespace whorl::app
