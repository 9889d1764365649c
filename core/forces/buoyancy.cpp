#include "core/forces/buoyancy.h"

namespace whorl {

void add_buoyancy(State& state, double alpha, double beta, double ambient, double dt, Pool& pool) {
    if (alpha == 0 && beta == 0) return;
    const Real weight = static_cast<Real>(-alpha * dt / 2);
    const Real lift = static_cast<Real>(beta * dt / 2);
    const Real still = static_cast<Real>(2 * ambient);
    Field& v = state.velocity.v;
    pool.bands(v.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const Real* density_above = state.density().row(j);
            const Real* density_below = state.density().row(j - 1);
            const Real* warmth_above = state.temperature().row(j);
            const Real* warmth_below = state.temperature().row(j - 1);
            Real* to = v.row(j);
            for (int i = 0; i < v.width(); ++i) {
                to[i] += weight * (density_below[i] + density_above[i]) +
                         lift * (warmth_below[i] + warmth_above[i] - still);
            }
        }
    });
}

}  // namespace whorl
