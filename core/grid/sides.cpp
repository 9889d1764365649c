#include "core/grid/sides.h"

#include <algorithm>

namespace whorl {

Registry<NamedSides>& NamedSides::list() {
    static const NamedSides box{{"box", "Closed box", "", "Four free-slip walls close the domain."},
                                sides::box};
    static const NamedSides periodic{
        {"periodic", "Periodic", "", "What leaves on one side comes in on the opposite one."},
        sides::periodic};
    static Registry<NamedSides> all("choice of sides", {&box, &periodic});
    return all;
}

const NamedSides& named(const Sides& sides) {
    const auto all = NamedSides::list().all();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const NamedSides* each) { return each->sides == sides; });
    if (found == all.end()) throw InputError("the scene's sides have no name to write them with");
    return **found;
}

}  // namespace whorl
