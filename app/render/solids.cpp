// See solids.h.
#include "app/render/solids.h"

#include <stdexcept>

#include "app/render/gl_state.h"
#include "shaders.h"

namespace whorl::app {
namespace {

constexpr float edge_points = 1.5f;

/// Greys that no smoke is mistaken for, sRGB.
struct Greys {
    glm::vec3 fill;
    glm::vec3 hatch;
    glm::vec3 edge;
};
constexpr Greys on_dark{{0.27f, 0.285f, 0.315f}, {0.36f, 0.375f, 0.41f}, {0.62f, 0.64f, 0.68f}};
constexpr Greys on_bright{{0.84f, 0.85f, 0.87f}, {0.70f, 0.72f, 0.75f}, {0.38f, 0.40f, 0.44f}};

/// Whether a map shows nothing, or 0, in a bright colour.
bool is_bright(const ColourMap& map) {
    const glm::vec3 rest = map.at(map.kind == ColourMap::Kind::Diverging ? 0.5f : 0.0f);
    return rest.r + rest.g + rest.b > 1.8f;
}

void set(GLint location, glm::vec2 value) {
    glUniform2f(location, value.x, value.y);
}
void set(GLint location, glm::vec3 value) {
    glUniform3f(location, value.x, value.y, value.z);
}

/// Calls `run(first, end)` for every longest run of k in [0, n) that `holds`.
template <class Holds, class Run>
void for_each_run(int n, Holds&& holds, Run&& run) {
    for (int k = 0; k < n; ++k) {
        if (!holds(k)) continue;
        const int first = k;
        while (k < n && holds(k)) ++k;
        run(static_cast<float>(first), static_cast<float>(k));
    }
}

}  // namespace

Solids::Solids() : program_("solid", shaders::solid_vert, shaders::solid_frag) {
    vertices_ = GlVertexArray::create();
    buffer_ = GlBuffer::create();
    const GlStateGuard guard;
    glBindVertexArray(vertices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Box), nullptr);
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Box),
                          reinterpret_cast<const void*>(sizeof(glm::vec4)));
    glVertexAttribDivisor(0, 1);
    glVertexAttribDivisor(1, 1);
}

void Solids::upload(std::span<const std::uint8_t> mask, int nx, int ny) {
    if (!mask.empty() && mask.size() != static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny)) {
        throw std::invalid_argument("a mask of solid cells has another size than its grid");
    }
    boxes_.clear();
    if (mask.empty()) return;
    nx_ = nx;
    ny_ = ny;
    add_rows(mask);
    add_edges(mask);
    const GlStateGuard guard;
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(boxes_.size() * sizeof(Box)), boxes_.data(),
                 GL_STATIC_DRAW);
}

void Solids::add_rows(std::span<const std::uint8_t> mask) {
    for (int j = 0; j < ny_; ++j) {
        const auto row = mask.subspan(static_cast<std::size_t>(j) * nx_, nx_);
        const auto y = static_cast<float>(j);
        for_each_run(
            nx_, [&](int i) { return row[i] != 0; },
            [&](float first, float end) {
                boxes_.push_back({{first, y, end, y + 1.0f}, {0.0f, 0.0f}});
            });
    }
}

void Solids::add_edges(std::span<const std::uint8_t> mask) {
    const auto solid = [&](int i, int j) { return mask[static_cast<std::size_t>(j) * nx_ + i] != 0; };
    for (int j = 1; j < ny_; ++j) {
        const auto y = static_cast<float>(j);
        for (const bool above : {false, true}) {
            for_each_run(
                nx_, [&](int i) { return solid(i, j) == above && solid(i, j - 1) != above; },
                [&](float first, float end) {
                    boxes_.push_back({{first, y, end, y}, {0.0f, above ? 1.0f : -1.0f}});
                });
        }
    }
    for (int i = 1; i < nx_; ++i) {
        const auto x = static_cast<float>(i);
        for (const bool right : {false, true}) {
            for_each_run(
                ny_, [&](int j) { return solid(i, j) == right && solid(i - 1, j) != right; },
                [&](float first, float end) {
                    boxes_.push_back({{x, first, x, end}, {right ? 1.0f : -1.0f, 0.0f}});
                });
        }
    }
}

void Solids::draw(const ColourMap& map, const FieldDraw& draw) {
    if (boxes_.empty() || draw.rect.width < 1 || draw.rect.height < 1) return;
    const Greys& greys = is_bright(map) ? on_bright : on_dark;
    const glm::vec2 cells(nx_, ny_);
    const glm::vec2 size(draw.rect.width, draw.rect.height);

    const GlStateGuard guard;
    const glm::ivec2 corner = enter(draw);
    program_.use();
    set(program_.uniform("pixel_origin"), draw.window.low * cells);
    set(program_.uniform("pixel_size"), (draw.window.high - draw.window.low) * cells / size);
    set(program_.uniform("size"), size);
    set(program_.uniform("corner"), glm::vec2(corner));
    glUniform1f(program_.uniform("scale"), draw.scale);
    glUniform1f(program_.uniform("thickness"), edge_points * draw.scale);
    set(program_.uniform("fill_colour"), greys.fill);
    set(program_.uniform("hatch_colour"), greys.hatch);
    set(program_.uniform("edge_colour"), greys.edge);
    glBindVertexArray(vertices_.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(boxes_.size()));
}

}  // namespace whorl::app
