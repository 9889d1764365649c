// The annulus carried along the diagonal.  [T sec. 5.1, 2d-TRANSLATION]
#include "core/experiments/annulus.h"
#include "core/experiments/experiment.h"

namespace whorl {

Experiment translation() {
    return {.info = {"translation", "Translation", "thesis sec. 5.1",
                     "An annulus moves along the diagonal; exact at all times."},
            .setup = thesis_test,
            .start =
                [](State& s) {
                    write_annulus(s.grid(), {10, 10}, s.density());
                },
            .flow = [](double, const Grid&, FaceVelocity& velocity) { write_uniform_flow(1, 1, velocity); },
            .exact =
                [](double time, double, const Grid& grid, Field& q) {
                    write_annulus(grid, {10 + time, 10 + time}, q);
                    return true;
                },
            .known = "always"};
}

}  // namespace whorl
