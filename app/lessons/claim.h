// What a lesson's text says in numbers, so that it can be checked.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/measure/measure.h"
#include "core/session/setup.h"

namespace whorl::app {

/// The measure of a key.  @throws InputError that names the nearest keys, and for times
const Measure& claimed_measure(std::string_view key);

/// A lane, by its place in the setup's, at a step.
struct LaneAtStep {
    std::size_t lane = 0;
    long step = 0;
    bool operator==(const LaneAtStep&) const = default;
};

/// A measure of a lane at a step, or its ratio to that of another lane or step, and between which numbers
/// it is said to lie.
struct Claim {
    const Measure* measure = nullptr;
    LaneAtStep place;
    std::optional<LaneAtStep> over;  ///< what it is divided by
    double least, most;
    unsigned line = 0, column = 0;  ///< where in the lesson's text it stands

    bool holds(double value) const { return value >= least && value <= most; }
    /// The furthest step that it needs.
    long last_step() const { return over && over->step > place.step ? over->step : place.step; }
};

/// "L1 of SL-LIN at step 1200", or a ratio of two such.
std::string describe(const Claim& claim, const Setup& setup);

/// "73.8 to 74", "at most 1".
std::string bounds(const Claim& claim);

}  // namespace whorl::app
