#include "app/lessons/claim.h"

#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/number.h"
#include "core/base/suggest.h"

namespace whorl::app {

std::span<const Quantity> quantities() {
    static constexpr Quantity table[] = {
        {"density_percent", [](const Measures& m) { return m.density_percent; }, false},
        {"kinetic_energy", [](const Measures& m) { return m.kinetic_energy; }, false},
        {"enstrophy", [](const Measures& m) { return m.enstrophy; }, false},
        {"min", [](const Measures& m) { return m.min_density; }, false},
        {"max", [](const Measures& m) { return m.max_density; }, false},
        {"L1", [](const Measures& m) { return m.errors.L1; }, false},
        {"L2", [](const Measures& m) { return m.errors.L2; }, false},
        {"Linf", [](const Measures& m) { return m.errors.Linf; }, false},
        {"effective_viscosity", [](const Measures& m) { return m.effective_viscosity; }, true},
    };
    return table;
}

const Quantity& quantity(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Quantity& q : quantities()) {
        if (q.key == key) return q;
        keys.push_back(q.key);
    }
    throw InputError("unknown measure \"" + std::string(key) + "\"; " + suggestion(key, keys));
}

std::string describe(const Claim& claim, const Setup& setup) {
    const std::vector<std::string> names = titles(setup);
    const auto of = [&](const Claim::Place& place) {
        const std::string lane = setup.lanes.size() > 1 ? " of " + names[place.lane] : "";
        return std::string(claim.quantity->key) + lane + " at step " + std::to_string(place.step);
    };
    return of(claim.place) + (claim.over ? " over " + of(*claim.over) : "");
}

std::string bounds(const Claim& claim) {
    if (std::isinf(claim.least)) return "at most " + figure(claim.most);
    if (std::isinf(claim.most)) return "at least " + figure(claim.least);
    return figure(claim.least) + " to " + figure(claim.most);
}

}  // namespace whorl::app
