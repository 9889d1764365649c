// See field_view.h.
#include "app/render/field_view.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/render/gl_state.h"
#include "shaders.h"

namespace whorl::app {
namespace {

/// More samples a pixel than this along a side cost more than they show.
constexpr int max_taps = 4;
/// Samples a pixel beyond a whole number that go unnoticed.
constexpr float bearable_skip = 0.3f;

void set(GLint location, glm::vec2 value) {
    glUniform2f(location, value.x, value.y);
}
void set(GLint location, glm::vec3 value) {
    glUniform3f(location, value.x, value.y, value.z);
}

/// The shader with names defined behind its first line, which says the version.
std::string with_defines(std::string_view source, std::string_view defines) {
    const std::size_t second_line = source.find('\n') + 1;
    return std::string(source.substr(0, second_line)) + std::string(defines) +
           std::string(source.substr(second_line));
}

glm::ivec2 domain_of(int width, int height, Site site, glm::ivec2 given) {
    if (given.x > 0 && given.y > 0) return given;
    return {width - (site == Site::FaceX ? 1 : 0), height - (site == Site::FaceY ? 1 : 0)};
}

}  // namespace

glm::ivec2 domain_of(const Field& field, glm::ivec2 given) {
    return domain_of(field.width(), field.height(), field.site(), given);
}

glm::ivec2 enter(const FieldDraw& draw) {
    const auto bottom = [&](const PixelRect& r) { return draw.framebuffer_height - r.y - r.height; };
    const glm::ivec2 corner(draw.rect.x, bottom(draw.rect));
    glViewport(corner.x, corner.y, draw.rect.width, draw.rect.height);
    if (draw.clip) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(draw.clip->x, bottom(*draw.clip), std::max(0, draw.clip->width),
                  std::max(0, draw.clip->height));
    }
    return corner;
}

FieldView::FieldView()
    : smooth_("field", shaders::screen_vert, shaders::field_frag),
      crisp_("field", shaders::screen_vert, with_defines(shaders::field_frag, "#define CRISP\n")),
      smooth_averaged_("field", shaders::screen_vert,
                       with_defines(shaders::field_frag, "#define AVERAGED\n")),
      crisp_averaged_("field", shaders::screen_vert,
                      with_defines(shaders::field_frag, "#define CRISP\n#define AVERAGED\n")) {
    vertices_ = GlVertexArray::create();
}

void FieldView::draw(const FieldTexture& field, const ColourMap& map, const FieldDraw& draw) {
    if (field.empty() || draw.rect.width < 1 || draw.rect.height < 1) return;
    map_.upload(map);
    const GlStateGuard guard;

    const glm::vec2 cells(domain_of(field.width(), field.height(), field.site(), draw.cells));
    const glm::vec2 corner(enter(draw));
    const glm::vec2 rect_size(draw.rect.width, draw.rect.height);
    const glm::vec2 pixel_size = (draw.window.high - draw.window.low) * cells / rect_size;
    const float span = draw.hi - draw.lo;
    const float densest = std::max(std::abs(pixel_size.x), std::abs(pixel_size.y));
    const int taps = std::clamp(static_cast<int>(std::ceil(densest - bearable_skip)), 1, max_taps);
    const Program& program =
        taps > 1 ? (draw.crisp ? crisp_averaged_ : smooth_averaged_) : (draw.crisp ? crisp_ : smooth_);

    program.use();
    glUniform1i(program.uniform("field"), 0);
    glUniform1i(program.uniform("map"), 1);
    set(program.uniform("corner"), corner);
    set(program.uniform("pixel_origin"), draw.window.low * cells);
    set(program.uniform("pixel_size"), pixel_size);
    set(program.uniform("cells"), cells);
    set(program.uniform("offset"), glm::vec2(offset_x(field.site()), offset_y(field.site())));
    set(program.uniform("range"), glm::vec2(draw.lo, span != 0.0f ? 1.0f / span : 1e30f));
    const bool shows_below = map.shows_below(draw.lo, draw.hi);
    const auto before = static_cast<float>(ColourMapTexture::before);
    set(program.uniform("texels"),
        glm::vec3(ColourMapTexture::along - 1, before, shows_below ? 0.0f : before));
    glUniform1i(program.uniform("taps"), taps);
    glUniform1f(program.uniform("chequer"), 1.0f / (5.0f * draw.scale));
    set(program.uniform("outside"), draw.outside);

    field.bind(0);
    map_.bind(1);
    glBindVertexArray(vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);

    glBindTexture(GL_TEXTURE_1D, 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace whorl::app
