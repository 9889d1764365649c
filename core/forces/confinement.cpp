#include "core/forces/confinement.h"

#include <cmath>

#include "core/measure/vorticity.h"

namespace whorl {

void Confinement::add(State& state, double epsilon, double dt, Pool& pool) {
    if (epsilon == 0) return;
    if (!vorticity_.same_shape(state.density())) {
        for (Field* field : {&vorticity_, &force_x_, &force_y_}) *field = state.boundary.field(Site::Centre);
    }
    vorticity(state.velocity, state.boundary, vorticity_, pool);

    constexpr Real tiny = 1e-20F;  // only keeps 0/0 away; no direction where |ω| is flat
    const Real half_over_h = static_cast<Real>(0.5 / state.grid().h);
    const Real scale = static_cast<Real>(epsilon * state.grid().h * dt);
    pool.bands(vorticity_.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const Real* w = vorticity_.row(j);
            const Real* below = vorticity_.row(j - 1);
            const Real* above = vorticity_.row(j + 1);
            for (int i = 0; i < vorticity_.width(); ++i) {
                const Real eta_x = (std::abs(w[i + 1]) - std::abs(w[i - 1])) * half_over_h;
                const Real eta_y = (std::abs(above[i]) - std::abs(below[i])) * half_over_h;
                const Real size = std::sqrt(eta_x * eta_x + eta_y * eta_y) + tiny;
                force_x_(i, j) = scale * eta_y / size * w[i];
                force_y_(i, j) = -scale * eta_x / size * w[i];
            }
        }
    });
    state.boundary.fill(force_x_);
    state.boundary.fill(force_y_);
    Field& u = state.velocity.u;
    pool.bands(u.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < u.width(); ++i) u(i, j) += (force_x_(i - 1, j) + force_x_(i, j)) * Real(0.5);
        }
    });
    Field& v = state.velocity.v;
    pool.bands(v.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            for (int i = 0; i < v.width(); ++i) v(i, j) += (force_y_(i, j - 1) + force_y_(i, j)) * Real(0.5);
        }
    });
}

}  // namespace whorl
