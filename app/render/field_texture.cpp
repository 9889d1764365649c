// See field_texture.h.
#include "app/render/field_texture.h"

#include <algorithm>
#include <stdexcept>
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

/// Makes `texture` the bound one, with storage of that size.
void reserve(GlTexture& texture, bool same_size, GLint internal, int width, int height, GLenum format,
             GLenum type) {
    const bool fresh = !texture;
    if (fresh) texture = GlTexture::create();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    if (!fresh && same_size) return;
    glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void bind_texture(const GlTexture& texture, int unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.name());
}

}  // namespace

void FieldTexture::upload(const Field& field) {
    const bool same_size = field.width() == width_ && field.height() == height_;
    width_ = field.width();
    height_ = field.height();
    site_ = field.site();
    if (empty()) return;
    reserve(texture_, same_size, GL_R32F, width_, height_, GL_RED, GL_FLOAT);
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
    bind_texture(texture_, unit);
}

void MaskTexture::upload(std::span<const std::uint8_t> mask, int nx, int ny) {
    if (mask.empty()) {
        nx_ = ny_ = 0;
        return;
    }
    if (mask.size() != static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny)) {
        throw std::invalid_argument("a mask of solid cells has another size than its grid");
    }
    const bool same_size = nx == nx_ && ny == ny_;
    nx_ = nx;
    ny_ = ny;
    const Unpack unpack(nx, 1);
    reserve(texture_, same_size, GL_R8UI, nx, ny, GL_RED_INTEGER, GL_UNSIGNED_BYTE);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, nx, ny, GL_RED_INTEGER, GL_UNSIGNED_BYTE, mask.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

void MaskTexture::bind(int unit) const {
    bind_texture(texture_, unit);
}

}  // namespace whorl::app
