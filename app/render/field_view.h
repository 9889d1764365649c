// A field on screen: its texture through a colour map.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "app/render/colour_map.h"
#include "app/render/field_texture.h"
#include "app/render/program.h"
#include "app/render/view_window.h"

namespace whorl::app {

/// A rectangle of framebuffer pixels, measured from the top left as ImGui does.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// How and where a field is drawn.
struct FieldDraw {
    PixelRect rect;
    int framebuffer_height = 0;  ///< of what is bound, pixels
    float scale = 1.0f;          ///< framebuffer pixels to a point, for what has a size of its own
    float lo = 0.0f;             ///< value at the map's start, the field's unit
    float hi = 1.0f;             ///< value at the map's end
    bool crisp = false;          ///< squares of one value each; else bilinear between samples
    ViewWindow window{};
    /// What lies outside stays as it is: two fields in one place, left and right of a line.
    std::optional<PixelRect> clip = {};
    /// Size of the domain, cells. 0 takes the field's own shape, a box's last face not counted.
    glm::ivec2 cells{0, 0};
    glm::vec3 outside{0.05f, 0.06f, 0.075f};  ///< colour beyond the domain, sRGB
};

/// The size of the domain that a field covers, cells: `given`, or where that is 0 the field's own shape, a
/// box's last face not counted.
glm::ivec2 domain_of(const Field& field, glm::ivec2 given = {0, 0});

/// Sets viewport and clip to those of `draw`; call inside a GlStateGuard.
/// @return the rectangle's lower left corner as OpenGL counts, framebuffer pixels from the bottom left
glm::ivec2 enter(const FieldDraw& draw);

/// Draws fields. Needs a current OpenGL context from construction to destruction.
class FieldView {
  public:
    FieldView();

    /// Draws into the bound framebuffer. Values that are no number show as a magenta chequer. A pixel that
    /// spans several samples averages their colours. Leaves viewport, program, vertex array and switches as
    /// they were, texture units 0 and 1 with no texture.
    void draw(const FieldTexture& field, const ColourMap& map, const FieldDraw& draw);

  private:
    // One program each: a software rasteriser pays for both sides of a condition.
    Program smooth_;
    Program crisp_;
    Program smooth_averaged_;
    Program crisp_averaged_;
    GlVertexArray vertices_;
    ColourMapTexture map_;
};

}  // namespace whorl::app
