#include "core/pressure/poisson.h"

#include <algorithm>

#include "core/parallel/row_bands.h"
#include "core/pressure/poisson_rows.h"

namespace whorl {

void Poisson::prepare(const Boundary& boundary, Pool& pool) {
    nx_ = boundary.grid().nx;
    ny_ = boundary.grid().ny;
    wraps_x_ = boundary.wraps().x && nx_ > 1;
    wraps_y_ = boundary.wraps().y && ny_ > 1;
    degrees_.assign(static_cast<std::size_t>(nx_ + 1) * ny_, 0);
    zeros_.assign(static_cast<std::size_t>(nx_), 0);
    row_largest_.assign(static_cast<std::size_t>(ny_), 0);

    const std::vector<std::uint8_t> outside(static_cast<std::size_t>(nx_), 1);
    const auto solids = [&](int j) {
        const int at = row(j);
        return at < 0 ? outside.data() : boundary.solids().data() + static_cast<std::size_t>(at) * nx_;
    };
    row_bands(pool, nx_, ny_, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            const std::uint8_t* south = solids(j - 1);
            const std::uint8_t* here = solids(j);
            const std::uint8_t* north = solids(j + 1);
            std::uint8_t* out = degrees_.data() + static_cast<std::size_t>(j) * (nx_ + 1);
            const auto count = [&](int i, bool west, bool east) {
                const int open = (south[i] == 0) + (north[i] == 0) + west + east;
                out[i] = static_cast<std::uint8_t>(here[i] == 0 ? open : 0);
            };
            for (int i = 1; i < nx_ - 1; ++i) count(i, here[i - 1] == 0, here[i + 1] == 0);
            const bool before = wraps_x_ && here[nx_ - 1] == 0;
            const bool after = wraps_x_ && here[0] == 0;
            count(0, before, nx_ > 1 ? here[1] == 0 : after);
            if (nx_ > 1) count(nx_ - 1, here[nx_ - 2] == 0, after);
        }
    });
}

template <class Row>
double Poisson::largest_of_rows(Pool& pool, Row&& row) const {
    row_bands(pool, nx_, ny_, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) row_largest_[j] = row(j);
    });
    double most = 0;
    for (const double value : row_largest_) most = std::max(most, value);
    return most;
}

double Poisson::residual(std::span<const double> b, std::span<const double> p, double scale,
                         std::span<double> r, Pool& pool) const {
    return largest_of_rows(pool, [&](int j) {
        const double* here = row_of(p, j);
        const rows::Ends ends{wraps_x_ ? here[nx_ - 1] : 0, wraps_x_ ? here[0] : 0};
        const std::size_t at = static_cast<std::size_t>(j) * nx_;
        return rows::residual(degrees(j), b.data() + at, row_of(p, j - 1), here, row_of(p, j + 1), ends,
                              scale, r.empty() ? nullptr : r.data() + at, nx_);
    });
}

double Poisson::largest_residual(std::span<const double> b, std::span<const double> p, Pool& pool) const {
    return residual(b, p, 1, {}, pool);
}

double Poisson::largest(std::span<const double> values, Pool& pool) const {
    return largest_of_rows(
        pool, [&](int j) { return rows::largest(values.data() + static_cast<std::size_t>(j) * nx_, nx_); });
}

}  // namespace whorl
