#include "core/measure/vorticity.h"

namespace whorl {

void vorticity(const FaceVelocity& velocity, const Boundary& boundary, Field& out, Pool& pool) {
    const Real quarter_over_h = static_cast<Real>(0.25 / boundary.grid().h);
    pool.bands(out.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const FaceRows rows = face_rows(velocity, j);
            Real* to = out.row(j);
            for (int i = 0; i < out.width(); ++i) to[i] = vorticity_at<Real>(rows, i, quarter_over_h);
        }
    });
    boundary.fill(out);
}

}  // namespace whorl
