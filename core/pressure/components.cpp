#include "core/pressure/components.h"

#include <cmath>

namespace whorl {

Components::Components(const Boundary& boundary) {
    const int nx = boundary.grid().nx;
    const int ny = boundary.grid().ny;
    labels_.assign(static_cast<std::size_t>(nx) * ny, -1);
    std::vector<int> todo;
    for (int start = 0; start < nx * ny; ++start) {
        if (labels_[start] >= 0 || boundary.solid(start % nx, start / nx)) continue;
        const int label = count();
        cells_.push_back(0);
        labels_[start] = label;
        todo.assign(1, start);
        while (!todo.empty()) {
            const int at = todo.back();
            todo.pop_back();
            ++cells_.back();
            constexpr int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
            for (const auto& step : steps) {
                const int i = at % nx + step[0];
                const int j = at / nx + step[1];
                if (boundary.solid(i, j)) continue;  // and so is everything outside a box
                const int to = (j + ny) % ny * nx + (i + nx) % nx;
                if (labels_[to] >= 0) continue;
                labels_[to] = label;
                todo.push_back(to);
            }
        }
    }
    sums_.assign(cells_.size(), 0);
}

double Components::remove_means(std::span<double> values) const {
    std::fill(sums_.begin(), sums_.end(), 0.0);
    for (std::size_t c = 0; c < values.size(); ++c) {
        if (labels_[c] >= 0) sums_[labels_[c]] += values[c];
    }
    double largest = 0;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
        sums_[k] /= cells_[k];
        if (std::abs(sums_[k]) > std::abs(largest)) largest = sums_[k];
    }
    for (std::size_t c = 0; c < values.size(); ++c)
        values[c] = labels_[c] >= 0 ? values[c] - sums_[labels_[c]] : 0;
    return largest;
}

}  // namespace whorl
