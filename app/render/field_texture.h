// Fields and masks in textures.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/render/gl_object.h"
#include "core/grid/field.h"

namespace whorl::app {

/// A field's interior as an R32F texture, a texel a sample, bottom row first.
class FieldTexture {
  public:
    /// Copies the field; allocates only when its shape changes.
    void upload(const Field& field);
    void bind(int unit) const;

    int width() const { return width_; }
    int height() const { return height_; }
    Site site() const { return site_; }
    bool empty() const { return width_ == 0 || height_ == 0; }

  private:
    GlTexture texture_;
    int width_ = 0;
    int height_ = 0;
    Site site_ = Site::Centre;
    std::vector<float> narrowed_;  ///< used where Real is double
};

/// A mask of solid cells as an R8UI texture, a texel a cell, bottom row first.
class MaskTexture {
  public:
    /// @param mask  nx × ny, row by row, non-zero is solid (Boundary::solids()); empty takes the mask away
    /// @throws std::invalid_argument if the mask has another size.
    void upload(std::span<const std::uint8_t> mask, int nx, int ny);
    void bind(int unit) const;
    bool empty() const { return nx_ == 0; }
    int nx() const { return nx_; }
    int ny() const { return ny_; }

  private:
    GlTexture texture_;
    int nx_ = 0;
    int ny_ = 0;
};

}  // namespace whorl::app
