// The loops over one row of a coarse grid, and those that carry a row from one grid to the next.
#pragma once

namespace whorl::rows {

// Rows of values have one more before their first and after their last sample, as in poisson_rows.h.

/// A row of a coarse grid's operator. (A z)_c = Σ k_f (z_c − z_n) over its faces f.
struct CoarseRow {
    const float* across;   ///< n + 1 coefficients of the faces that x crosses; face i lies before cell i
    const float* south;    ///< n coefficients of the faces below
    const float* north;    ///< n coefficients of the faces above
    const float* inverse;  ///< 1 / Σ k_f, 0 where that is 0
};

/// out = w b / Σ k_f
void first_smoothing(const CoarseRow& row, const float* b, float w, float* out, int n);
/// out = z + w (b − A z) / Σ k_f
void smoothing(const CoarseRow& row, const float* b, const float* south, const float* here,
               const float* north, float w, float* out, int n);
/// out = b − A z
void smoothed_residual(const CoarseRow& row, const float* b, const float* south, const float* here,
                       const float* north, float* out, int n);

/// How much a cell's value leans towards its neighbours' when it is carried to its four children: ¼ across an
/// open face, 0 across a closed one. Each child adds one such term in x and one in y.
struct CornerWeights {
    const float* across;  ///< n + 1
    const float* south;   ///< n
    const float* north;   ///< n
};

/// Adds the children's residuals to their parents, by the transpose of `carry`.
/// @param below the children of the row below that face this one; so `above`
/// @param low   the lower children; `high` the upper ones
/// @param out   n coarse values
/// Fine rows have a value before their first sample and two after their last: the children beyond the ends.
void gather(const CornerWeights& lean, const float* below, const float* low, const float* high,
            const float* above, float* out, int n);

/// out = z + what a row of n parents gives to one row of its children.
/// @param beside  the parents' neighbours on that row's side
/// @param towards the leaning towards them
/// @param z, out  2 n fine values
void carry(const float* across, const float* towards, const float* parents, const float* beside,
           const float* z, float* out, int n);

}  // namespace whorl::rows
