// See field_texture.h.
#include "app/render/field_texture.h"

#include <algorithm>
#include <type_traits>

namespace whorl::app {
namespace {

/// Sets how rows lie in memory for the uploads of a scope, and puts OpenGL's defaults back.
class Unpack {
  public:
    Unpack(int row_length, int alignment) {
        glPixelStorei(GL_UNPACK_ROW_LENGTH, row_length);
        glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
    }
    ~Unpack() {
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    }
    Unpack(const Unpack&) = delete;
    Unpack& operator=(const Unpack&) = delete;
};

}  // namespace

void FieldTexture::upload(const Field& field) {
    const bool same_size = field.width() == width_ && field.height() == height_;
    width_ = field.width();
    height_ = field.height();
    site_ = field.site();
    if (empty()) return;
    const bool fresh = !texture_;
    if (fresh) texture_ = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    if (fresh || !same_size) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width_, height_, 0, GL_RED, GL_FLOAT, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    if constexpr (std::is_same_v<Real, float>) {
        const Unpack unpack(field.stride(), 4);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RED, GL_FLOAT, field.row(0));
    } else {
        narrowed_.resize(static_cast<std::size_t>(width_) * height_);
        for (int j = 0; j < height_; ++j) {
            std::transform(field.row(j), field.row(j) + width_,
                           narrowed_.begin() + std::ptrdiff_t{j} * width_,
                           [](Real value) { return static_cast<float>(value); });
        }
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RED, GL_FLOAT, narrowed_.data());
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

void FieldTexture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture_.name());
}

}  // namespace whorl::app
