#include "core/pressure/components.h"

#include <algorithm>
#include <cmath>

#include "core/parallel/row_bands.h"
#include "core/pressure/vector_clones.h"

namespace whorl {
namespace {

int root_of(std::vector<int>& parents, int k) {
    while (parents[k] != k) {
        parents[k] = parents[parents[k]];
        k = parents[k];
    }
    return k;
}

void join(std::vector<int>& parents, int a, int b) {
    a = root_of(parents, a);
    b = root_of(parents, b);
    parents[std::max(a, b)] = std::min(a, b);
}

/// Zeroes what is not kept.
/// @return the sum of the rest, over eight lanes
WHORL_VECTOR_CLONES
double keep_and_sum(const std::uint8_t* __restrict keep, double* __restrict values, int n) {
    constexpr int lanes = 8;
    double lane[lanes] = {};
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int k = 0; k < lanes; ++k) {
            values[i + k] = keep[i + k] > 0 ? values[i + k] : 0;
            lane[k] += values[i + k];
        }
    }
    for (int k = 0; i < n; ++i, ++k) {
        values[i] = keep[i] > 0 ? values[i] : 0;
        lane[k] += values[i];
    }
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

WHORL_VECTOR_CLONES
void subtract(const std::uint8_t* __restrict keep, double mean, double* __restrict values, int n) {
    for (int i = 0; i < n; ++i) values[i] -= mean * keep[i];
}

}  // namespace

Components::Components(const Boundary& boundary) : nx_(boundary.grid().nx), ny_(boundary.grid().ny) {
    const std::size_t all = static_cast<std::size_t>(nx_) * ny_;
    row_sums_.assign(static_cast<std::size_t>(ny_), 0);
    keep_.resize(all);
    std::transform(boundary.solids().begin(), boundary.solids().end(), keep_.begin(),
                   [](std::uint8_t solid) { return static_cast<std::uint8_t>(solid == 0); });
    if (!boundary.has_solids()) {
        labels_.assign(all, 0);
        cells_.assign(1, nx_ * ny_);
    } else {
        std::vector<int> parents;
        find_runs(boundary, parents);
        std::vector<int> label_of(parents.size(), -1);
        for (int& label : labels_) {
            if (label < 0) continue;
            const int root = root_of(parents, label);
            if (label_of[root] < 0) {
                label_of[root] = count();
                cells_.push_back(0);
            }
            label = label_of[root];
            ++cells_[label];
        }
    }
    sums_.assign(cells_.size(), 0);
    list_small();
}

/// Labels each run of fluid cells in a row, and joins the runs that touch.
void Components::find_runs(const Boundary& boundary, std::vector<int>& parents) {
    const std::uint8_t* solid = boundary.solids().data();
    labels_.assign(static_cast<std::size_t>(nx_) * ny_, -1);
    for (int j = 0; j < ny_; ++j) {
        int* row = labels_.data() + static_cast<std::size_t>(j) * nx_;
        const int* below = row - nx_;
        for (int i = 0; i < nx_; ++i) {
            if (solid[static_cast<std::size_t>(j) * nx_ + i]) continue;
            if (i > 0 && row[i - 1] >= 0) {
                row[i] = row[i - 1];
            } else {
                row[i] = static_cast<int>(parents.size());
                parents.push_back(row[i]);
            }
            const bool met = i > 0 && row[i - 1] >= 0 && j > 0 && below[i - 1] >= 0;
            if (j > 0 && below[i] >= 0 && !met) join(parents, row[i], below[i]);
        }
        if (boundary.wraps().x && row[0] >= 0 && row[nx_ - 1] >= 0) join(parents, row[0], row[nx_ - 1]);
    }
    if (!boundary.wraps().y) return;
    const int* top = labels_.data() + static_cast<std::size_t>(ny_ - 1) * nx_;
    for (int i = 0; i < nx_; ++i) {
        if (labels_[i] >= 0 && top[i] >= 0) join(parents, labels_[i], top[i]);
    }
}

void Components::list_small() {
    if (count() < 2) return;
    largest_ = static_cast<int>(std::max_element(cells_.begin(), cells_.end()) - cells_.begin());
    for (int c = 0; c < nx_ * ny_; ++c) {
        if (labels_[c] < 0 || labels_[c] == largest_) continue;
        small_.push_back(c);
        keep_[c] = 0;
    }
    small_values_.assign(small_.size(), 0);
}

double Components::remove_means(std::span<double> values, Pool& pool) const {
    // The largest component row by row; the few cells of the others one by one.
    std::fill(sums_.begin(), sums_.end(), 0.0);
    for (std::size_t k = 0; k < small_.size(); ++k) {
        small_values_[k] = values[small_[k]];
        sums_[labels_[small_[k]]] += small_values_[k];
    }
    row_bands(pool, nx_, ny_, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const std::size_t at = static_cast<std::size_t>(j) * nx_;
            row_sums_[j] = keep_and_sum(keep_.data() + at, values.data() + at, nx_);
        }
    });
    if (count() == 0) return 0;
    for (const double row : row_sums_) sums_[largest_] += row;
    double most = 0;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
        sums_[k] /= cells_[k];
        if (std::abs(sums_[k]) > std::abs(most)) most = sums_[k];
    }
    const double mean = sums_[largest_];
    row_bands(pool, nx_, ny_, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const std::size_t at = static_cast<std::size_t>(j) * nx_;
            subtract(keep_.data() + at, mean, values.data() + at, nx_);
        }
    });
    for (std::size_t k = 0; k < small_.size(); ++k)
        values[small_[k]] = small_values_[k] - sums_[labels_[small_[k]]];
    return most;
}

}  // namespace whorl
