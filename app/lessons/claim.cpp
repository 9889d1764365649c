#include "app/lessons/claim.h"

#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"

namespace whorl::app {

const Measure& claimed_measure(std::string_view key) {
    const Measure& measure = measures().find(key);
    if (measure.timing) throw InputError(measure.key + " is a time of the machine's: no lesson can state it");
    return measure;
}

std::string describe(const Claim& claim, const Setup& setup) {
    const std::vector<std::string> names = titles(setup);
    const auto of = [&](const LaneAtStep& place) {
        const std::string lane = setup.lanes.size() > 1 ? " of " + names[place.lane] : "";
        return claim.measure->key + lane + " at step " + std::to_string(place.step);
    };
    return of(claim.place) + (claim.over ? " over " + of(*claim.over) : "");
}

std::string bounds(const Claim& claim) {
    if (std::isinf(claim.least)) return "at most " + figure(claim.most);
    if (std::isinf(claim.most)) return "at least " + figure(claim.least);
    return figure(claim.least) + " to " + figure(claim.most);
}

}  // namespace whorl::app
