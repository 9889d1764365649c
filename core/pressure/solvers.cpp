// The table of pressure solvers, a line each.
#include "core/pressure/ldlt.h"

namespace whorl {

std::span<const PressureSolverEntry> pressure_solvers() {
    static constexpr PressureSolverEntry table[] = {
        {Ldlt::info, [](double) -> std::unique_ptr<PressureSolver> { return std::make_unique<Ldlt>(); }},
    };
    return table;
}

}  // namespace whorl
