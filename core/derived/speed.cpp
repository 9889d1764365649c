// The speed at cell centres.
#include <cmath>

#include "core/derived/derived.h"

namespace whorl {
namespace {

/// |u| of the mean of opposite faces.
void compute(const State& state, Pool& pool, Field& out) {
    pool.bands(out.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const Real* u = state.velocity.u.row(j);
            const Real* v = state.velocity.v.row(j);
            const Real* v_above = state.velocity.v.row(j + 1);
            for (int i = 0; i < out.width(); ++i) {
                const Real x = (u[i] + u[i + 1]) * Real(0.5);
                const Real y = (v[i] + v_above[i]) * Real(0.5);
                out(i, j) = std::sqrt(x * x + y * y);
            }
        }
    });
}

}  // namespace

extern const DerivedField speed{
    "speed",
    {"Speed", "length/time", "|u| at cell centres.", "viridis", FieldDisplay::Middle::None, 30},
    compute};

}  // namespace whorl
