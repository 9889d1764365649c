// The divergence of the velocity.
#include "core/derived/derived.h"

namespace whorl {
namespace {

/// ∇·u from a cell's four faces.
void compute(const State& state, Pool& pool, Field& out) {
    const Real over_h = static_cast<Real>(1 / state.grid().h);
    pool.bands(out.height(), [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const Real* u = state.velocity.u.row(j);
            const Real* v = state.velocity.v.row(j);
            const Real* v_above = state.velocity.v.row(j + 1);
            for (int i = 0; i < out.width(); ++i) out(i, j) = (u[i + 1] - u[i] + v_above[i] - v[i]) * over_h;
        }
    });
}

}  // namespace

extern const DerivedField divergence{
    "divergence",
    {"Divergence", "1/time", "∇·u at the step's end: what the next projection takes away.", "blue-dark-red",
     FieldDisplay::Middle::Zero, 60},
    compute};

}  // namespace whorl
