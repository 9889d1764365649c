#include "core/pressure/multigrid_aggregation.h"

#include <algorithm>

namespace whorl {
namespace {

/// Where each row starts in a list sorted by rows.
template <class RowOf>
std::vector<int> starts(const std::vector<Aggregation::Orphan>& all, int rows, RowOf&& row_of) {
    std::vector<int> first(static_cast<std::size_t>(rows) + 1, 0);
    for (const Aggregation::Orphan& each : all) ++first[static_cast<std::size_t>(row_of(each)) + 1];
    for (int row = 0; row < rows; ++row) first[row + 1] += first[row];
    return first;
}

int wrapped(int i, int n, bool wraps) {
    if (i >= 0 && i < n) return i;
    return wraps ? (i + n) % n : -1;
}

}  // namespace

void Aggregation::clear() {
    parent_sides_.clear();
    orphans_.clear();
    of_row_.clear();
    of_parent_.clear();
    row_starts_.clear();
    parent_starts_.clear();
}

Aggregation::Cell Aggregation::beside(Cell c, ParentSide side) const {
    const int i = wrapped(c.i + (side == East) - (side == West), fine_.nx, fine_.wraps_x);
    const int j = wrapped(c.j + (side == North) - (side == South), fine_.ny, fine_.wraps_y);
    return {i, j};
}

Aggregation::Cell Aggregation::parent(Cell child) const {
    const ParentSide where = parent_side(child);
    if (where == None) return {-1, -1};
    const int i = child.i / 2 + (where == East) - (where == West);
    const int j = child.j / 2 + (where == North) - (where == South);
    return {wrapped(i, coarse_.nx, coarse_.wraps_x), wrapped(j, coarse_.ny, coarse_.wraps_y)};
}

void Aggregation::list() {
    if (orphans_.empty()) return;
    for (const Cell c : orphans_) {
        const Cell p = parent(c);
        of_row_.push_back({c.i, c.j, p.i, p.j});
        if (p.i >= 0) of_parent_.push_back(of_row_.back());
    }
    std::stable_sort(of_row_.begin(), of_row_.end(), [](const auto& a, const auto& b) { return a.j < b.j; });
    std::stable_sort(of_parent_.begin(), of_parent_.end(),
                     [](const auto& a, const auto& b) { return a.parent_j < b.parent_j; });
    row_starts_ = starts(of_row_, fine_.ny, [](const Orphan& each) { return each.j; });
    parent_starts_ = starts(of_parent_, coarse_.ny, [](const Orphan& each) { return each.parent_j; });
}

}  // namespace whorl
