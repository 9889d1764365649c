#include "core/measure/average.h"

#include <algorithm>
#include <cstdint>

#include "core/scene/state.h"

namespace whorl {
namespace {

/// In units of 1/(fine · coarse) of the axis all edges are whole numbers.
Overlap overlap(int cell, std::int64_t fine, std::int64_t coarse) {
    const std::int64_t low = cell * fine;
    const std::int64_t high = low + fine;
    const std::int64_t first = low / coarse;
    const std::int64_t last = (high - 1) / coarse;
    const auto share = [&](std::int64_t i) {
        return static_cast<double>(std::min(high, (i + 1) * coarse) - std::max(low, i * coarse)) /
               static_cast<double>(fine);
    };
    return {static_cast<int>(first), static_cast<int>(last), share(first),
            static_cast<double>(coarse) / static_cast<double>(fine), share(last)};
}

/// Calls `work(i, share)` for the cells of an overlap, in order.
template <class Work>
void for_cells(const Overlap& o, Work&& work) {
    work(o.first, o.first_share);
    for (int i = o.first + 1; i < o.last; ++i) work(i, o.inner_share);
    if (o.last > o.first) work(o.last, o.last_share);
}

}  // namespace

void Averager::average(const Field& q, const Boundary& from, const Grid& to, Field& out) {
    const Grid& grid = from.grid();
    if (grid.nx == to.nx && grid.ny == to.ny) {
        for (int j = 0; j < to.ny; ++j) std::copy(q.row(j), q.row(j) + to.nx, out.row(j));
    } else if (grid.nx >= to.nx && grid.ny >= to.ny) {
        average_down(q, grid, to, out);
    } else {
        write_samples(out, to, [&](WorldPoint at) { return value_at(q, from, at); });
    }
}

void Averager::average_down(const Field& q, const Grid& from, const Grid& to, Field& out) {
    columns_.resize(static_cast<std::size_t>(to.nx));
    row_.resize(columns_.size());
    sum_.resize(columns_.size());
    for (int i = 0; i < to.nx; ++i) columns_[i] = overlap(i, from.nx, to.nx);
    int averaged = -1;  // the row of q that row_ holds: one that two rows of cells share is averaged once
    for (int j = 0; j < to.ny; ++j) {
        std::fill(sum_.begin(), sum_.end(), 0.0);
        for_cells(overlap(j, from.ny, to.ny), [&](int fine_j, double height) {
            if (fine_j != averaged) {
                averaged = fine_j;
                const Real* fine = q.row(fine_j);
                for (int i = 0; i < to.nx; ++i) {
                    double mean = 0;
                    for_cells(columns_[i], [&](int fine_i, double width) {
                        mean += width * static_cast<double>(fine[fine_i]);
                    });
                    row_[i] = mean;
                }
            }
            for (int i = 0; i < to.nx; ++i) sum_[i] += height * row_[i];
        });
        for (int i = 0; i < to.nx; ++i) out(i, j) = static_cast<Real>(sum_[i]);
    }
}

}  // namespace whorl
