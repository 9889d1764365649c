// The vorticity at cell centres.
#include "core/measure/vorticity.h"
#include "core/derived/derived.h"

namespace whorl {
namespace {

void compute(const State& state, Pool& pool, Field& out) {
    vorticity(state.velocity, state.boundary, out, pool);
}

}  // namespace

extern const DerivedField vorticity_field{
    "vorticity",
    {"Vorticity", "1/time", "ω = ∂v/∂x − ∂u/∂y: red turns to the left, blue to the right.", "blue-dark-red",
     FieldDisplay::Middle::Zero, 40},
    compute};

}  // namespace whorl
