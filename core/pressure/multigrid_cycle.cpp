#include "core/pressure/multigrid_cycle.h"

#include <algorithm>
#include <utility>

namespace whorl {
namespace {

/// 1 / the roots of the Chebyshev polynomial of degree 2 on [½, 2], (5 ± 3/√2) / 4. The eigenvalues of D⁻¹A
/// lie in [0, 2]; coarser grids take care of those below ½.  [Adams et al. 2003]
constexpr float first_weight = 0.56164F;
constexpr float second_weight = 1.38952F;

/// Four rows of scratch in turn: the row of t is there until t + 4 comes.
struct Ring {
    PaddedRows* rows;
    int base;
    float* operator[](int t) const { return rows->row(base + (t & 3)); }
};

/// Values of row t, or 0 where there is no such row; `make(j, out)` computes row j.
template <class Make>
void make_row(const LevelShape& shape, int t, float* out, Make&& make) {
    const int j = shape.row(t);
    if (j < 0) {
        std::fill(out - 2, out + shape.nx + 2, 0.0F);
        return;
    }
    make(j, out);
    border(out, shape.nx, shape.wraps_x);
}

/// The values beside a row of residuals, for `gather`: the facing child of the last cell's, which an odd row
/// has not, and of the first one's.
void border_of_children(float* row, int nx, bool wraps) {
    const bool odd = nx % 2 != 0;
    row[-1] = wraps && !odd ? row[nx - 1] : 0;
    row[nx] = wraps && !odd ? row[0] : 0;
    row[nx + 1] = wraps && odd ? row[0] : 0;
}

/// Smooths from 0 and gathers the residual: level.work.half and coarse.b, for coarse rows [begin, end).
template <class Level>
void down_band(Level& level, CoarseLevel& coarse, int begin, int end, int unit) {
    const LevelShape& shape = level.shape;
    const int last = std::min(2 * end, shape.ny);
    PaddedRows& scratch = level.work.scratch;
    const Ring once{&scratch, unit * rows_of_scratch};
    const Ring beside{&scratch, unit * rows_of_scratch + 4};
    const Ring left{&scratch, unit * rows_of_scratch + 8};
    const Ring orphans{&scratch, unit * rows_of_scratch + 12};
    // Rows inside the band are kept, those beside it are needed on the way alone.
    const auto twice = [&](int t) { return t >= 2 * begin && t < last ? level.work.half.row(t) : beside[t]; };
    // With an odd number of wrapped rows the last coarse row has no upper children.
    const bool childless = shape.wraps_y && shape.ny % 2 != 0;

    for (int t = 2 * begin - 3; t < 2 * end + 3; ++t) {
        make_row(shape, t, once[t], [&](int j, float* out) { level.first_smoothing(j, first_weight, out); });
        if (t < 2 * begin - 1) continue;
        make_row(shape, t - 1, twice(t - 1), [&](int j, float* out) {
            level.smoothing(j, once[t - 2], once[t - 1], once[t], second_weight, out);
        });
        if (t < 2 * begin + 1) continue;
        make_row(shape, t - 2, left[t - 2], [&](int j, float* out) {
            level.residual(j, twice(t - 3), twice(t - 2), twice(t - 1), out);
        });
        if (const int j = shape.row(t - 2); j >= 0) {
            for (const Aggregation::Orphan& child : coarse.aggregation.in_row(j))
                orphans[t - 2][child.i] = std::exchange(left[t - 2][child.i], 0.0F);
        }
        border_of_children(left[t - 2], shape.nx, shape.wraps_x);
        const int parent = (t - 4) / 2;
        if (t % 2 != 0 || t < 2 * begin + 4) continue;
        const float* below = left[2 * parent - 1];
        const float* high = left[2 * parent + 1];
        const float* above = left[2 * parent + 2];
        if (childless && (parent == 0 || parent == coarse.shape.ny - 1)) {
            float* none = once[t + 1];  // overwritten next
            std::fill(none - 2, none + shape.nx + 2, 0.0F);
            if (parent == 0) below = none;
            if (parent == coarse.shape.ny - 1) {
                above = high;
                high = none;
            }
        }
        rows::gather(coarse.corner_weights(parent), below, left[2 * parent], high, above,
                     coarse.b.row(parent), coarse.shape.nx);
        for (const Aggregation::Orphan& child : coarse.aggregation.by_row(parent)) {
            int row = child.j;  // one of four around this parent, perhaps wrapped
            if (row > 2 * parent + 2) row -= shape.ny;
            if (row < 2 * parent - 1) row += shape.ny;
            coarse.b.row(parent)[child.parent_i] += orphans[row][child.i];
        }
    }
}

/// Carries the coarse solution back and smooths: level.work.whole, for rows [begin, end).
template <class Level>
void up_band(Level& level, const CoarseLevel& coarse, int begin, int end, int unit) {
    const LevelShape& shape = level.shape;
    PaddedRows& scratch = level.work.scratch;
    const Ring carried{&scratch, unit * rows_of_scratch};
    const Ring once{&scratch, unit * rows_of_scratch + 4};

    for (int t = begin - 2; t < end + 2; ++t) {
        make_row(shape, t, carried[t], [&](int j, float* out) {
            const int parent = j / 2;
            const bool lower = j % 2 == 0;
            const int at = coarse.shape.row(lower ? parent - 1 : parent + 1);
            const float* parents = coarse.work.whole.row(parent);
            const rows::CornerWeights lean = coarse.corner_weights(parent);
            rows::carry(lean.across, lower ? lean.south : lean.north, parents,
                        at < 0 ? parents : coarse.work.whole.row(at), level.work.half.row(j), out,
                        coarse.shape.nx);
            for (const Aggregation::Orphan& child : coarse.aggregation.in_row(j)) {
                const float given =
                    child.parent_i < 0 ? 0 : coarse.work.whole.row(child.parent_j)[child.parent_i];
                out[child.i] = level.work.half.row(j)[child.i] + given;
            }
            level.after_carry(j, out);
        });
        if (t < begin) continue;
        make_row(shape, t - 1, once[t - 1], [&](int j, float* out) {
            level.smoothing(j, carried[t - 2], carried[t - 1], carried[t], second_weight, out);
        });
        if (t < begin + 2) continue;
        float* out = level.work.whole.row(t - 2);
        level.smoothing(t - 2, once[t - 3], once[t - 2], once[t - 1], first_weight, out);
        border(out, shape.nx, shape.wraps_x);
        level.finished(t - 2, out);
    }
}

template <class Level>
void cycle(Level& level, std::vector<CoarseLevel>& coarser, std::size_t next, Pool& pool) {
    const LevelShape& shape = level.shape;
    if (next == coarser.size()) {  // one cell, whose pressure is any constant
        level.work.whole.fill(0);
        level.finished(0, level.work.whole.row(0));
        return;
    }
    CoarseLevel& coarse = coarser[next];
    const int units = (shape.ny + rows_of_unit - 1) / rows_of_unit;
    constexpr int coarse_unit = rows_of_unit / 2;
    pool.bands(units, [&](int begin, int end) {
        down_band(level, coarse, begin * coarse_unit, std::min(end * coarse_unit, coarse.shape.ny), begin);
    });
    cycle(coarse, coarser, next + 1, pool);
    pool.bands(units, [&](int begin, int end) {
        up_band(level, coarse, begin * rows_of_unit, std::min(end * rows_of_unit, shape.ny), begin);
    });
}

}  // namespace

void v_cycle(Levels& levels, Pool& pool) {
    cycle(levels.fine, levels.coarse, 0, pool);
}

}  // namespace whorl
