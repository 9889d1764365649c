// The pressure equation's matrix, without a matrix: how many open faces each cell has.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/grid/boundary.h"
#include "core/parallel/pool.h"

namespace whorl {

/// (A p)_c = d_c p_c − Σ p_n over the four neighbours n, where d_c counts the open faces of c and p is 0 in
/// solid cells and outside a box; 0 where d_c is 0. The Laplacian [T 2.17b; F 57] times −h².
///
/// A periodic direction of one cell has no faces: its cell would only meet itself.
class Poisson {
  public:
    Poisson() = default;
    void prepare(const Boundary& boundary, Pool& pool);

    int nx() const { return nx_; }
    int ny() const { return ny_; }
    /// Whether a direction is periodic with more than one cell.
    bool wraps_x() const { return wraps_x_; }
    bool wraps_y() const { return wraps_y_; }
    /// Open faces of each cell of row j, 0 … 4; followed by one more entry, 0.
    const std::uint8_t* degrees(int j) const {
        return degrees_.data() + static_cast<std::size_t>(j) * (nx_ + 1);
    }
    /// The row of cells at j, wrapped where that is periodic; −1 outside a box.
    int row(int j) const {
        if (j >= 0 && j < ny_) return j;
        return wraps_y_ ? (j % ny_ + ny_) % ny_ : -1;
    }

    /// r = scale (b − A p).
    /// @return max |r|
    double residual(std::span<const double> b, std::span<const double> p, double scale, std::span<double> r,
                    Pool& pool) const;
    /// max |b − A p|
    double largest_residual(std::span<const double> b, std::span<const double> p, Pool& pool) const;
    /// max |values|
    double largest(std::span<const double> values, Pool& pool) const;

  private:
    template <class Row>
    double largest_of_rows(Pool& pool, Row&& row) const;
    const double* row_of(std::span<const double> values, int j) const {
        const int at = row(j);
        return at < 0 ? zeros_.data() : values.data() + static_cast<std::size_t>(at) * nx_;
    }

    int nx_ = 0;
    int ny_ = 0;
    bool wraps_x_ = false;
    bool wraps_y_ = false;
    std::vector<std::uint8_t> degrees_;
    std::vector<double> zeros_;
    mutable std::vector<double> row_largest_;
};

/// max |b − A p| over max |b|, 0 if b is 0.
inline double relative_residual(const Poisson& poisson, std::span<const double> b, std::span<const double> p,
                                Pool& pool) {
    const double largest = poisson.largest(b, pool);
    return largest > 0 ? poisson.largest_residual(b, p, pool) / largest : 0;
}

}  // namespace whorl
