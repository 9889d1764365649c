// The thesis' rising plume.  [T sec. 5.4]
#include "core/experiments/experiment.h"

namespace whorl {

// The thesis gives ρ, T and how long the emitter works, but neither its size nor α and β. These are chosen so
// that with linear semi-Lagrangian advection at 40² the plume's head reaches the lid between steps 360 and
// 480.
Experiment plume() {
    return {.info = {"plume", "Rising plume", "thesis sec. 5.4",
                     "Warm smoke rises in a closed box from an emitter that works for 600 steps."},
            .setup =
                [](Scene& s) {
                    s.alpha = 0.5;
                    s.beta = 0.35;
                    s.steps = 1200;
                    s.emitters = {{.x = 20,
                                   .y = 1,
                                   .width = 4,
                                   .height = 2,
                                   .amounts = {{field::density, 0.5}, {field::temperature, 50}},
                                   .from = 0,
                                   .until = 10}};
                },
            .start = nullptr,
            .flow = nullptr,
            .exact = nullptr};
}

}  // namespace whorl
