// The table of pressure solvers, a line each.
#include "core/pressure/automatic.h"
#include "core/pressure/conjugate_gradient.h"
#include "core/pressure/diagonalization.h"
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
        {Automatic::info, create<Automatic>, never, false},
        {Ldlt::info, create<Ldlt>, never, true},
        {ConjugateGradient::info, create<ConjugateGradient>, never, false},
        {Multigrid::info, create<Multigrid>, never, false},
        {Diagonalization::info, create<Diagonalization>, Diagonalization::unsupported_reason, false},
    };
    return table;
}

}  // namespace whorl
