// The grids of a multigrid cycle: half as many cells each way from one to the next, down to one cell.
#pragma once

#include <vector>

#include "core/pressure/coarse_rows.h"
#include "core/pressure/multigrid_aggregation.h"
#include "core/pressure/padded_rows.h"
#include "core/pressure/poisson.h"

namespace whorl {

/// What a cycle works on at each grid: solutions before and after the coarser grids' part, and rows at hand.
struct LevelWork {
    PaddedRows half;     ///< after the smoothing on the way down
    PaddedRows whole;    ///< the result
    PaddedRows scratch;  ///< rows_of_scratch for each unit of rows
};

/// The finest grid: Poisson's cells with a right side in double.
struct FineLevel {
    LevelShape shape;
    const Poisson* poisson = nullptr;
    const double* b = nullptr;             ///< nx × ny
    mutable std::vector<double> row_dots;  ///< Σ b z over each row of the result z, as the cycle finishes it
    LevelWork work;

    void first_smoothing(int j, float w, float* out) const;
    void smoothing(int j, const float* south, const float* here, const float* north, float w,
                   float* out) const;
    void residual(int j, const float* south, const float* here, const float* north, float* out) const;
    void after_carry(int j, float* row) const;
    void finished(int j, const float* row) const;
};

/// A coarser grid. Its faces' coefficients are the open parts of the finer faces that make them: the flux
/// through a face twice as long between centres twice as far apart.  [McAdams et al. 2010, sec. 3, whose
/// coarse cells are all or nothing; open parts keep the number of iterations lower around small obstacles]
struct CoarseLevel {
    LevelShape shape;
    PaddedRows across;   ///< faces that x crosses: nx + 1 a row
    PaddedRows along;    ///< faces that y crosses: ny + 1 rows
    PaddedRows inverse;  ///< 1 / Σ of a cell's faces, 0 if none is open
    PaddedRows lean_across, lean_along;
    Aggregation aggregation;  ///< of the finer grid's cells
    PaddedRows b;
    LevelWork work;

    void first_smoothing(int j, float w, float* out) const {
        rows::first_smoothing(row(j), b.row(j), w, out, shape.nx);
    }
    void smoothing(int j, const float* south, const float* here, const float* north, float w,
                   float* out) const {
        rows::smoothing(row(j), b.row(j), south, here, north, w, out, shape.nx);
    }
    void residual(int j, const float* south, const float* here, const float* north, float* out) const {
        rows::smoothed_residual(row(j), b.row(j), south, here, north, out, shape.nx);
    }
    void after_carry(int, float*) const {}
    void finished(int, const float*) const {}
    rows::CoarseRow row(int j) const {
        return {across.row(j), along.row(j), along.row(j + 1), inverse.row(j)};
    }
    rows::CornerWeights corner_weights(int j) const {
        return {lean_across.row(j), lean_along.row(j), lean_along.row(j + 1)};
    }
};

/// All grids of one domain.
struct Levels {
    FineLevel fine;
    std::vector<CoarseLevel> coarse;

    /// @param poisson lives as long as these levels
    /// Costs a few passes over the cells; allocates only if the shape is another one than before.
    void prepare(const Boundary& boundary, const Poisson& poisson, Pool& pool);
};

/// Rows that a band keeps at hand, and the number of rows between two bands' possible starts.
constexpr int rows_of_scratch = 16;
constexpr int rows_of_unit = 32;

}  // namespace whorl
