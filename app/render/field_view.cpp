// See field_view.h.
#include "app/render/field_view.h"

#include <algorithm>
#include <cmath>

#include "app/render/gl_state.h"
#include "shaders.h"

namespace whorl::app {
namespace {

/// More samples a pixel than this along a side cost more than they show.
constexpr int max_taps = 4;

/// Greys that no smoke is mistaken for, sRGB.
struct SolidColours {
    glm::vec3 fill;
    glm::vec3 hatch;
    glm::vec3 edge;
};
constexpr SolidColours on_dark{{0.27f, 0.285f, 0.315f}, {0.36f, 0.375f, 0.41f}, {0.62f, 0.64f, 0.68f}};
constexpr SolidColours on_bright{{0.84f, 0.85f, 0.87f}, {0.70f, 0.72f, 0.75f}, {0.38f, 0.40f, 0.44f}};

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

}  // namespace

glm::ivec2 domain_of(const FieldTexture& field, const FieldDraw& draw) {
    if (draw.cells.x > 0 && draw.cells.y > 0) return draw.cells;
    return {field.width() - (field.site() == Site::FaceX ? 1 : 0),
            field.height() - (field.site() == Site::FaceY ? 1 : 0)};
}

FieldView::FieldView() : program_("field", shaders::screen_vert, shaders::field_frag) {
    vertices_ = GlVertexArray::create();
    const std::uint8_t fluid[1] = {0};
    no_solids_.upload(fluid, 1, 1);
}

void FieldView::draw(const FieldTexture& field, const ColourMap& map, const MaskTexture* solids,
                     const FieldDraw& draw) {
    if (field.empty() || draw.rect.width < 1 || draw.rect.height < 1) return;
    map_.upload(map);
    const GlStateGuard guard;

    const glm::vec2 cells(domain_of(field, draw));
    const glm::vec2 corner(draw.rect.x, draw.framebuffer_height - draw.rect.y - draw.rect.height);
    const glm::vec2 rect_size(draw.rect.width, draw.rect.height);
    const glm::vec2 pixel_size = (draw.window.high - draw.window.low) * cells / rect_size;
    const float span = draw.hi - draw.lo;
    const float densest = std::max(std::abs(pixel_size.x), std::abs(pixel_size.y));
    const bool has_solids = solids != nullptr && !solids->empty();

    glViewport(static_cast<GLint>(corner.x), static_cast<GLint>(corner.y), draw.rect.width, draw.rect.height);
    program_.use();
    glUniform1i(program_.uniform("field"), 0);
    glUniform1i(program_.uniform("map"), 1);
    glUniform1i(program_.uniform("solids"), 2);
    set(program_.uniform("corner"), corner);
    set(program_.uniform("pixel_origin"), draw.window.low * cells);
    set(program_.uniform("pixel_size"), pixel_size);
    set(program_.uniform("cells"), cells);
    set(program_.uniform("offset"), glm::vec2(offset_x(field.site()), offset_y(field.site())));
    set(program_.uniform("range"), glm::vec2(draw.lo, span != 0.0f ? 1.0f / span : 1e30f));
    glUniform1i(program_.uniform("crisp"), draw.crisp ? 1 : 0);
    glUniform1i(program_.uniform("has_solids"), has_solids ? 1 : 0);
    glUniform1i(program_.uniform("taps"),
                std::clamp(static_cast<int>(std::ceil(densest - 0.25f)), 1, max_taps));
    glUniform1f(program_.uniform("scale"), draw.scale);
    const SolidColours& grey = is_bright(map) ? on_bright : on_dark;
    set(program_.uniform("solid_fill"), grey.fill);
    set(program_.uniform("solid_hatch"), grey.hatch);
    set(program_.uniform("solid_edge"), grey.edge);
    set(program_.uniform("outside"), draw.outside);

    field.bind(0);
    map_.bind(1);
    (has_solids ? *solids : no_solids_).bind(2);
    glBindVertexArray(vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);

    for (const GLenum unit : {GL_TEXTURE2, GL_TEXTURE0}) {
        glActiveTexture(unit);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_1D, 0);
}

}  // namespace whorl::app
