// Rows of floats with room beside them for a neighbour's value.
#pragma once

#include <cstddef>
#include <vector>

namespace whorl {

/// `ny` rows of `nx` floats, with `pad` more on both sides of each.
class PaddedRows {
  public:
    /// Room for two values beyond a row's ends; a whole cache line, so that rows do not share one.
    static constexpr int pad = 16;

    void resize(int nx, int ny) {
        stride_ = (nx + 2 * pad + pad - 1) / pad * pad;
        values_.assign(static_cast<std::size_t>(stride_) * ny, 0.0F);
    }
    float* row(int j) { return values_.data() + static_cast<std::size_t>(j) * stride_ + pad; }
    const float* row(int j) const { return values_.data() + static_cast<std::size_t>(j) * stride_ + pad; }
    void fill(float value) { values_.assign(values_.size(), value); }

  private:
    int stride_ = 0;
    std::vector<float> values_;
};

/// Writes the values beside a row: those of its other end where x wraps, else 0.
inline void border(float* row, int nx, bool wraps) {
    row[-1] = wraps ? row[nx - 1] : 0;
    row[nx] = wraps ? row[0] : 0;
}

}  // namespace whorl
