// The annulus' cross-section carried along one axis.  [T sec. 5.1, 1d-TRANSLATION]
#include "core/experiments/annulus.h"
#include "core/experiments/experiment.h"

namespace whorl {

Experiment translation_1d() {
    return {.info = {"translation-1d", "Translation, 1D", "thesis sec. 5.1",
                     "The cross-section of an annulus moves by one length a second; exact at all times."},
            .setup =
                [](Scene& s) {
                    thesis_test(s);
                    s.dimensions = 1;
                },
            .start =
                [](State& s) {
                    write_annulus(s.grid(), {10, 0}, s.density());
                },
            .flow = [](double, const Grid&, FaceVelocity& velocity) { write_uniform_flow(1, 0, velocity); },
            .exact =
                [](double time, double, const Grid& grid, Field& q) {
                    write_annulus(grid, {10 + time, 0}, q);
                    return true;
                },
            .known = "always"};
}

}  // namespace whorl
