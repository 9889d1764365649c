// Bands of rows that are worth a thread, for loops of a nanosecond a cell.
#pragma once

#include <algorithm>

#include "core/parallel/pool.h"

namespace whorl {

/// Calls `work(first, last)` on bands that cover [0, ny) rows of nx cells, as Pool::bands does, but on the
/// calling thread alone where another one would take longer to start than it saves: below some 8000 cells a
/// band.
template <class Work>
void row_bands(Pool& pool, int nx, int ny, Work&& work) {
    constexpr int cells_of_unit = 4096;  // of which the pool gives a thread four or more
    const int unit = std::max(1, cells_of_unit / std::max(1, nx));
    pool.bands((ny + unit - 1) / unit,
               [&](int first, int last) { work(first * unit, std::min(last * unit, ny)); });
}

}  // namespace whorl
