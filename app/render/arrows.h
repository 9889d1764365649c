// Velocity as arrows over a field.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "app/render/field_view.h"
#include "core/grid/field.h"

namespace whorl::app {

/// How velocity arrows are laid out.
struct ArrowStyle {
    float spacing = 26.0f;    ///< between arrows, points; also the longest arrow
    float full_speed = 0.0f;  ///< speed of the longest arrow, length/time; 0 takes the fastest shown
    std::span<const std::uint8_t> solids =
        {};  ///< nx × ny, non-zero is solid: no arrows there; empty for none
};

/// Draws thin arrows at the nodes of a coarse lattice, legible on any colour map.
class Arrows {
  public:
    Arrows();

    /// Draws over the rectangle and window of `draw` into the bound framebuffer; its values are not read.
    /// @pre style.solids has the grid's size or is empty
    /// Nothing is drawn for velocities too small to see and for those that are no number.
    void draw(const FaceVelocity& velocity, const FieldDraw& draw, const ArrowStyle& style = {});

    /// The fastest speed that these arrows would show, length/time; 0 without any. Give the fastest of
    /// several fields to all of them as `full_speed`, and their arrows compare.
    float fastest(const FaceVelocity& velocity, const FieldDraw& draw, const ArrowStyle& style = {});

  private:
    /// Between arrows, framebuffer pixels.
    static float spacing(const FieldDraw& draw, const ArrowStyle& style);
    /// Puts places and velocities into `arrows_`.
    /// @return the fastest speed
    float collect(const FaceVelocity& velocity, const FieldDraw& draw, const ArrowStyle& style);

    Program program_;
    GlVertexArray vertices_;
    GlBuffer buffer_;
    /// Tail and extent, framebuffer pixels from the rectangle's lower left corner.
    std::vector<glm::vec4> arrows_;
};

}  // namespace whorl::app
