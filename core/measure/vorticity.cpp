#include "core/measure/vorticity.h"

namespace whorl {

void vorticity(const FaceVelocity& velocity, const Boundary& boundary, Field& out, Pool& pool) {
    // The central difference of two face averages: a quarter over h.
    const Real scale = static_cast<Real>(0.25 / boundary.grid().h);
    pool.bands(out.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const Real* v = velocity.v.row(j);
            const Real* v_above = velocity.v.row(j + 1);
            const Real* u_below = velocity.u.row(j - 1);
            const Real* u_above = velocity.u.row(j + 1);
            Real* to = out.row(j);
            for (int i = 0; i < out.width(); ++i) {
                to[i] = scale * ((v[i + 1] + v_above[i + 1]) - (v[i - 1] + v_above[i - 1]) -
                                 (u_above[i] + u_above[i + 1]) + (u_below[i] + u_below[i + 1]));
            }
        }
    });
    boundary.fill(out);
}

}  // namespace whorl
