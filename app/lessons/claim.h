// What a lesson's text says in numbers, so that it can be checked.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/measure/measures.h"
#include "core/session/setup.h"

namespace whorl::app {

/// A number that can be stated of a lane at a step.
struct Quantity {
    std::string_view key;  ///< as in the columns of `whorl compare --csv`
    double (*of)(const Measures&);
    bool mean;  ///< over the steps up to then: a single step's says more of that step than of the scheme
};

/// All quantities.
std::span<const Quantity> quantities();

/// @throws InputError that names the nearest keys
const Quantity& quantity(std::string_view key);

/// A quantity of a lane at a step, or its ratio to that of another lane or step, and between which numbers
/// it is said to lie.
struct Claim {
    /// Of what: a lane, as a place in the setup's, and a step.
    struct Place {
        std::size_t lane = 0;
        long step = 0;
        bool operator==(const Place&) const = default;
    };
    const Quantity* quantity = nullptr;
    Place place;
    std::optional<Place> over;  ///< what it is divided by
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
