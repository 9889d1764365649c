// From a value to a colour: the maps that pictures of fields are drawn with.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "app/render/gl_object.h"

namespace whorl::app {

/// Evenly spaced control points, linear in sRGB between them.
struct ColourMap {
    enum class Kind {
        Sequential,  ///< from little to much
        Diverging,   ///< two colours away from a neutral middle: show it on a range symmetric about 0
    };

    std::string_view key;
    std::string_view label;
    Kind kind;
    std::span<const std::uint32_t> points;  ///< 0xRRGGBB, at least two

    /// Colour at t, sRGB in [0, 1]; t below 0 and above 1 take the ends, NaN the lower one.
    glm::vec3 at(float t) const;
};

/// All maps; the first is the default.
std::span<const ColourMap> colour_maps();
/// The map of that key, or null.
const ColourMap* find_colour_map(std::string_view key);

/// A map in a one-dimensional texture, for the shaders: the nearest texel to t is ColourMap::at(t) in 8 bits.
class ColourMapTexture {
  public:
    /// Uploads the map; does nothing if they are there already.
    void upload(const ColourMap& map);
    void bind(int unit) const;

  private:
    GlTexture texture_;
    std::string_view key_;
};

}  // namespace whorl::app
