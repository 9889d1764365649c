// One V-cycle: an approximate inverse of the pressure equation's matrix, symmetric, as conjugate gradient
// asks.
#pragma once

#include "core/pressure/multigrid_levels.h"

namespace whorl {

/// levels.fine.work.whole ≈ A⁻¹ levels.fine.b, in single precision.  [McAdams et al. 2010, alg. 1]
///
/// Two steps of Jacobi on each grid on the way down and two on the way up, weighted by the roots of a
/// Chebyshev polynomial. A row passes through all of a grid's stages while it is in the cache. Rows depend on
/// their neighbours alone, so bands compute the rows beside them anew and results are the same for any
/// banding.
void v_cycle(Levels& levels, Pool& pool);

}  // namespace whorl
