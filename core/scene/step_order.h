// The orders of a step: lists of phases by key.
#pragma once

#include <vector>

#include "core/base/registry.h"
#include "core/base/scheme_info.h"

namespace whorl {

/// What a step does, one phase after the other.
struct StepOrder {
    struct Part {
        std::string_view phase;  ///< key, see phases()
        double share = 1;        ///< of Δt; the parts of one phase need not add up to 1
    };
    SchemeInfo info;
    std::vector<Part> parts;
};

/// The orders that a scene may choose; the first is the default.
Registry<StepOrder>& step_orders();

/// Where the flow is prescribed, nothing is solved.
extern const StepOrder prescribed_order;

}  // namespace whorl
