// See reduction.h.
#include "core/measure/reduction.h"

#include "core/measure/measure.h"
#include "core/parallel/row_bands.h"

namespace whorl {

void Reducer::reduce(const State& state, Pool& pool, std::vector<Reduced>& reduced) {
    if (reduced.empty()) return;
    const Grid& grid = state.grid();
    const std::size_t count = reduced.size();
    rows_.assign(count * static_cast<std::size_t>(grid.ny), {});
    row_bands(pool, grid.nx, grid.ny, [&](int first, int last) {
        for (int j = first; j < last; ++j) {
            const RowView row{.state = state,
                              .j = j,
                              .y = (j + 0.5) * grid.h,
                              .h = grid.h,
                              .density = state.density().row(j),
                              .temperature = state.temperature().row(j),
                              .u = state.velocity.u.row(j),
                              .v_below = state.velocity.v.row(j),
                              .v_above = state.velocity.v.row(j + 1)};
            for (std::size_t k = 0; k < count; ++k)
                reduced[k].measure->row(row, rows_[count * static_cast<std::size_t>(j) + k]);
        }
    });
    for (std::size_t k = 0; k < count; ++k) {
        Sums& sums = reduced[k].sums;
        sums = {};
        for (std::size_t at = k; at < rows_.size(); at += count) {
            for (std::size_t s = 0; s < sums.size(); ++s) sums[s] += rows_[at][s];
        }
    }
}

}  // namespace whorl
