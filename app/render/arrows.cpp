// See arrows.h.
#include "app/render/arrows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/render/gl_state.h"
#include "shaders.h"

namespace whorl::app {
namespace {

/// Value between samples, bilinear; `place` in cells from the domain's corner.
float sample(const Field& field, glm::vec2 place) {
    const float x = std::clamp(place.x - static_cast<float>(offset_x(field.site())), 0.0f,
                               static_cast<float>(field.width() - 1));
    const float y = std::clamp(place.y - static_cast<float>(offset_y(field.site())), 0.0f,
                               static_cast<float>(field.height() - 1));
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const int right = std::min(i + 1, field.width() - 1);
    const int above = std::min(j + 1, field.height() - 1);
    const auto value = [&](int a, int b) { return static_cast<float>(field(a, b)); };
    const float low = std::lerp(value(i, j), value(right, j), x - static_cast<float>(i));
    const float high = std::lerp(value(i, above), value(right, above), x - static_cast<float>(i));
    return std::lerp(low, high, y - static_cast<float>(j));
}

bool is_solid(std::span<const std::uint8_t> solids, int nx, glm::vec2 place) {
    if (solids.empty()) return false;
    const int ny = static_cast<int>(solids.size()) / nx;
    const int i = std::clamp(static_cast<int>(place.x), 0, nx - 1);
    const int j = std::clamp(static_cast<int>(place.y), 0, ny - 1);
    return solids[static_cast<std::size_t>(j) * nx + i] != 0;
}

}  // namespace

Arrows::Arrows() : program_("arrow", shaders::arrow_vert, shaders::arrow_frag) {
    vertices_ = GlVertexArray::create();
    buffer_ = GlBuffer::create();
    const GlStateGuard guard;
    glBindVertexArray(vertices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(glm::vec4), nullptr);
    glVertexAttribDivisor(0, 1);
}

float Arrows::spacing(const FieldDraw& draw, const ArrowStyle& style) {
    return std::max(style.spacing * draw.scale, 4.0f);
}

float Arrows::collect(const FaceVelocity& velocity, const FieldDraw& draw, const ArrowStyle& style) {
    arrows_.clear();
    const glm::vec2 size(draw.rect.width, draw.rect.height);
    const glm::ivec2 count(size / spacing(draw, style));
    const glm::vec2 cells(velocity.v.width(), velocity.u.height());
    float fastest = 0.0f;
    if (count.x < 1 || count.y < 1 || cells.x < 1 || cells.y < 1) return fastest;
    for (int b = 0; b < count.y; ++b) {
        for (int a = 0; a < count.x; ++a) {
            const glm::vec2 part((static_cast<float>(a) + 0.5f) / static_cast<float>(count.x),
                                 (static_cast<float>(b) + 0.5f) / static_cast<float>(count.y));
            const glm::vec2 place = (draw.window.low + part * (draw.window.high - draw.window.low)) * cells;
            if (is_solid(style.solids, velocity.v.width(), place)) continue;
            const glm::vec2 u(sample(velocity.u, place), sample(velocity.v, place));
            const float speed = glm::length(u);
            if (!std::isfinite(speed)) continue;
            fastest = std::max(fastest, speed);
            arrows_.emplace_back(part * size, u);
        }
    }
    return fastest;
}

float Arrows::fastest(const FaceVelocity& velocity, const FieldDraw& draw, const ArrowStyle& style) {
    return collect(velocity, draw, style);
}

void Arrows::draw(const FaceVelocity& velocity, const FieldDraw& draw, const ArrowStyle& style) {
    const float fastest = collect(velocity, draw, style);
    const float full = style.full_speed > 0.0f ? style.full_speed : fastest;
    if (full <= 0.0f) return;
    const float longest = 0.9f * spacing(draw, style);
    for (glm::vec4& arrow : arrows_) {
        glm::vec2 extent = glm::vec2(arrow.z, arrow.w) * (longest / full);
        const float length = glm::length(extent);
        if (length > longest) extent *= longest / length;
        arrow = glm::vec4(glm::vec2(arrow.x, arrow.y) - 0.5f * extent, extent);
    }
    std::erase_if(arrows_,
                  [&](const glm::vec4& arrow) { return std::hypot(arrow.z, arrow.w) < 2.0f * draw.scale; });
    if (arrows_.empty()) return;

    const GlStateGuard guard;
    enter(draw);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    program_.use();
    glUniform2f(program_.uniform("size"), static_cast<float>(draw.rect.width),
                static_cast<float>(draw.rect.height));
    glUniform1f(program_.uniform("scale"), draw.scale);
    glBindVertexArray(vertices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(arrows_.size() * sizeof(glm::vec4)), arrows_.data(),
                 GL_STREAM_DRAW);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(arrows_.size()));
}

}  // namespace whorl::app
