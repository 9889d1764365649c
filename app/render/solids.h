// Solid cells over a field.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "app/render/field_view.h"

namespace whorl::app {

/// Draws solid cells in quiet hatched grey with an edge towards the fluid. They are rectangles, made anew
/// only when the mask changes: a mask in the field's shader would cost every pixel.
class Solids {
  public:
    Solids();

    /// @param mask  nx × ny, row by row, non-zero is solid (Boundary::solids()); empty takes the solids away
    /// @throws std::invalid_argument if the mask has another size.
    void upload(std::span<const std::uint8_t> mask, int nx, int ny);
    bool empty() const { return boxes_.empty(); }

    /// Draws over the rectangle and window of `draw` into the bound framebuffer; its values are not read.
    /// @param map  what the field is drawn with: bright maps take other greys than dark ones
    void draw(const ColourMap& map, const FieldDraw& draw);

  private:
    struct Box {
        glm::vec4 corners;  ///< cells
        glm::vec2 inward;   ///< 0, or into the solid if this is its edge
    };
    void add_rows(std::span<const std::uint8_t> mask);
    void add_edges(std::span<const std::uint8_t> mask);

    Program program_;
    GlVertexArray vertices_;
    GlBuffer buffer_;
    int nx_ = 0;
    int ny_ = 0;
    std::vector<Box> boxes_;  ///< edges last, so that they lie on top
};

}  // namespace whorl::app
