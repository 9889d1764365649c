// What to ask of a run's steps beside their fields.
#pragma once

#include <optional>
#include <vector>

#include "core/phases/last_advection.h"
#include "core/scene/state.h"

namespace whorl {

struct Measure;

/// Costs time in each step or snapshot, so that it is asked for only while someone looks.
struct Watch {
    /// In every lane, the node of a quantity that is nearest to a point.
    struct Node {
        FieldId quantity = field::density;
        WorldPoint at{};  ///< length
        bool operator==(const Node& o) const {
            return quantity == o.quantity && at.x == o.at.x && at.y == o.at.y;
        }
    };
    std::optional<Node> node;                ///< to explain, in snapshots
    bool limiters = false;                   ///< where they act, at every step
    std::vector<const Measure*> measures{};  ///< at every step; see Session::ask

    bool any() const { return node || limiters; }
    bool operator==(const Watch&) const = default;
};

}  // namespace whorl
