// One scalar quantity sampled on the grid: its values, where they sit, and a border of ghost values.
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/real.h"
#include "core/grid/grid.h"

namespace whorl {

/// `width × height` samples at `site`, row by row from the bottom, with `ghost` more on every side.
/// Ghost values are what Boundary::fill last wrote there.
class Field {
  public:
    /// As deep as the widest kernel reaches from a point inside the domain.
    static constexpr int ghost = 2;

    Field() = default;
    Field(int width, int height, Site site, Real value = 0)
        : width_(width),
          height_(height),
          stride_(width + 2 * ghost),
          site_(site),
          values_(static_cast<std::size_t>(stride_) * (height + 2 * ghost), value) {}

    int width() const { return width_; }
    int height() const { return height_; }
    Site site() const { return site_; }
    /// Distance in memory from a sample to the one above it.
    int stride() const { return stride_; }

    /// Sample (i, j), with i in [-ghost, width + ghost) and j likewise.
    Real& operator()(int i, int j) { return values_[index(i, j)]; }
    Real operator()(int i, int j) const { return values_[index(i, j)]; }

    /// The first sample of row j; ghost values lie before it and after its width.
    Real* row(int j) { return values_.data() + index(0, j); }
    const Real* row(int j) const { return values_.data() + index(0, j); }

    void set_all(Real value) { values_.assign(values_.size(), value); }
    /// All values with the ghost border, row by row: the field's whole memory.
    const std::vector<Real>& memory() const { return values_; }
    bool same_shape(const Field& other) const {
        return width_ == other.width_ && height_ == other.height_ && site_ == other.site_;
    }

  private:
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j + ghost) * stride_ + static_cast<std::size_t>(i + ghost);
    }

    int width_ = 0;
    int height_ = 0;
    int stride_ = 0;
    Site site_ = Site::Centre;
    std::vector<Real> values_;
};

/// Velocity on the staggered (MAC) grid: `u` at x faces, `v` at y faces, length/time.
struct FaceVelocity {
    Field u;
    Field v;
};

}  // namespace whorl
