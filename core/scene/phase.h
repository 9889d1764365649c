// The phases of a step: what each does to a state.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/registry.h"

namespace whorl {

struct StepContext;  // core/phases/step_context.h

/// Where the curves of a phase have their colours, and their place among others.
struct PhaseCurves {
    int in_budget;  ///< of what it gave or took of energy and enstrophy
    int in_times;   ///< of its milliseconds
};

struct Phase {
    std::string_view key;
    std::string_view title;
    /// Allocates nothing.
    void (*run)(const StepContext&);
    /// Whether what it takes from the flow is numerical: it then counts for the effective viscosity.
    bool dissipates = false;
    /// Nothing for one that no measure tells of.
    std::optional<PhaseCurves> curves{};
};

/// All phases. Their bodies are in core/phases.
Registry<Phase>& phases();

}  // namespace whorl
