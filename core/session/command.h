// What a person can do to a session, as values: input becomes commands that act between steps.
#pragma once

#include <variant>
#include <vector>

#include "core/session/setup.h"
#include "core/sources/edit.h"

namespace whorl {

/// Another set of lanes: more, fewer, changed or in another order.
struct Arrange {
    std::vector<LaneSetup> lanes;
    std::vector<int> from;  ///< for each, the present lane whose fields it goes on with
    int reference = no_reference;
    bool operator==(const Arrange&) const = default;
};

/// Back to the start of the scene and the lanes as they are now set.
struct Restart {
    bool operator==(const Restart&) const = default;
};

/// SetParameter changes the scene of all lanes; a lane's own overrides stay. An Edit goes into all lanes.
using Command = std::variant<SetParameter, Edit, Arrange, Restart>;

}  // namespace whorl
