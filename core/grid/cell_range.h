// A rectangle of cells.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/grid/grid.h"

namespace whorl {

/// The cells from (begin_i, begin_j) up to and without (end_i, end_j).
struct CellRange {
    int begin_i = 0, begin_j = 0, end_i = 0, end_j = 0;

    bool contains(int i, int j) const { return i >= begin_i && i < end_i && j >= begin_j && j < end_j; }
    bool empty() const { return begin_i >= end_i || begin_j >= end_j; }
    bool operator==(const CellRange&) const = default;
};

/// The cells of a grid that a rectangle (length units) meets.
inline CellRange cells_in(const Grid& grid, double left, double bottom, double right, double top) {
    const auto within = [&](double index, int n) {
        return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(n)));
    };
    return {within(std::floor(left / grid.h), grid.nx), within(std::floor(bottom / grid.h), grid.ny),
            within(std::ceil(right / grid.h), grid.nx), within(std::ceil(top / grid.h), grid.ny)};
}

}  // namespace whorl
