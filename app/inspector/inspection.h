// What a person has chosen to inspect: a node of the grid, whose value is then taken apart.
#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "app/render/view_window.h"
#include "core/inspect/explanation.h"
#include "core/session/watch.h"

namespace whorl::app {

/// Shared by the inspector's window, its tool, and what is drawn over the fields.
struct Inspection {
    bool open = false;
    Watch::Node node;      ///< the point that was clicked, and of what quantity
    bool picked = false;   ///< whether one was
    std::size_t step = 0;  ///< the base step that is drawn over the field, see Explanation::steps
    /// A product under the pointer: of which base step's sum, and which one of it.
    struct Pointed {
        std::size_t step, term;
    };
    std::optional<Pointed> pointed;
    bool goes_closer = false;  ///< the field is to be seen closer once the node is explained

    void pick(WorldPoint at) {
        node.at = at;
        picked = true;
    }
    /// What to watch of the run.
    std::optional<Watch::Node> watched() const { return open && picked ? std::optional(node) : std::nullopt; }
    /// The base step to draw.
    std::size_t shown(const Explanation& explanation) const {
        return std::min(pointed ? pointed->step : step, explanation.steps.size() - 1);
    }
};

/// The sum behind a base step's value: the whole one, or of predictor-correctors a part of it.
const Sum& sum_of(const Explanation& explanation, std::size_t step);

/// The part of the domain that shows a node with all its paths and what was read, which fill about half of it
/// where the closest view lets them.
/// @param others  of the same node in the lanes beside it, which share the view: all of them is seen too
/// @param domain  its sides, length
/// @param h       side of a cell, length
ViewWindow window_around(const Explanation& chosen, std::span<const Explanation* const> others,
                         glm::dvec2 domain, double h);

}  // namespace whorl::app
