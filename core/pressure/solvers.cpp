// The table of pressure solvers, a line each.
#include "core/pressure/ldlt.h"
#include "core/pressure/multigrid.h"

namespace whorl {
namespace {

template <class Solver>
std::unique_ptr<PressureSolver> create() {
    return std::make_unique<Solver>();
}

std::string_view never(const Boundary&) {
    return {};
}

}  // namespace

std::span<const PressureSolverEntry> pressure_solvers() {
    static constexpr PressureSolverEntry table[] = {
        {Ldlt::info, create<Ldlt>, never, true},
        {Multigrid::info, create<Multigrid>, never, false},
    };
    return table;
}

}  // namespace whorl
