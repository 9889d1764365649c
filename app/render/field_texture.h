// Fields in textures.
#pragma once

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

}  // namespace whorl::app
