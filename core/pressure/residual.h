// How well a pressure solves its equation.
#pragma once

#include <span>

#include "core/grid/boundary.h"

namespace whorl {

/// max |b − A p| over max |b|, 0 if b is 0; A as in PressureSolver.
double relative_residual(const Boundary& boundary, std::span<const double> b, std::span<const double> p);

}  // namespace whorl
