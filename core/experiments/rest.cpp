// The annulus where nothing moves: what a step at rest does is all the scheme's.
#include "core/experiments/annulus.h"
#include "core/experiments/experiment.h"

namespace whorl {

Experiment rest() {
    return {.info = {"rest", "At rest", "",
                     "Nothing moves. Semi-Lagrangian schemes leave the annulus as it is; ASLAM squares it."},
            .setup = thesis_test,
            .start =
                [](State& s) {
                    write_annulus(s.grid(), {20, 30}, s.density());
                },
            .flow = [](double, const Grid&, FaceVelocity& velocity) { write_uniform_flow(0, 0, velocity); },
            .exact =
                [](double, double, const Grid& grid, Field& q) {
                    write_annulus(grid, {20, 30}, q);
                    return true;
                },
            .known = "always"};
}

}  // namespace whorl
