// A closed box of still, clear air, for the mouse.
#include "core/experiments/experiment.h"

namespace whorl {

Experiment empty() {
    return {.info = {"empty", "Empty box", "", "Still, clear air in a closed box: paint with the mouse."},
            .setup = [](Scene& s) { s.beta = 0.35; },
            .start = nullptr,
            .flow = nullptr,
            .exact = nullptr,
            .listed = false};
}

}  // namespace whorl
