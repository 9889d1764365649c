// Vorticity at cell centres.
#pragma once

#include "core/grid/boundary.h"
#include "core/parallel/pool.h"
#include "core/parallel/simd.h"

namespace whorl {

/// The face velocities in and around a row of cells; `u_below` and `u_above` may be ghosts.
struct FaceRows {
    const Real* u_below;
    const Real* u;
    const Real* u_above;
    const Real* v;
    const Real* v_above;
};
inline FaceRows face_rows(const FaceVelocity& velocity, int j) {
    return {velocity.u.row(j - 1), velocity.u.row(j), velocity.u.row(j + 1), velocity.v.row(j),
            velocity.v.row(j + 1)};
}

/// ω = ∂v/∂x − ∂u/∂y by central differences of the velocity at centres, 1/time: of cell i, or of as many
/// cells from i on as T has lanes.  [F 28–30]
/// @param quarter_over_h 1/(4h): each difference spans two cells, each velocity at a centre is a mean of two
template <class T>
WHORL_INLINE T vorticity_at(const FaceRows& rows, int i, T quarter_over_h) {
    const T right = load<T>(rows.v + i + 1) + load<T>(rows.v_above + i + 1);
    const T left = load<T>(rows.v + i - 1) + load<T>(rows.v_above + i - 1);
    const T above = load<T>(rows.u_above + i) + load<T>(rows.u_above + i + 1);
    const T below = load<T>(rows.u_below + i) + load<T>(rows.u_below + i + 1);
    return quarter_over_h * (right - left - above + below);
}

/// The vorticity of all cells.
/// @param velocity ghosts filled
/// @param out      at centres; its ghosts are filled
void vorticity(const FaceVelocity& velocity, const Boundary& boundary, Field& out, Pool& pool);

}  // namespace whorl
