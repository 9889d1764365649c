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

    /// Whether values below `lo` have a colour of their own.
    bool shows_below(float lo, float hi) const { return kind == Kind::Sequential && lo <= 0.0f && lo < hi; }
    /// Colour at t, sRGB in [0, 1]; t below 0 and above 1 take the ends, NaN the lower one.
    glm::vec3 at(float t) const;
};

/// Of values below the start of a sequential map that begins at 0 or under it, where there should be none: a
/// colour that no such map has.
inline constexpr glm::vec3 below_colour{0.10f, 0.78f, 0.74f};
/// How far below it is full, and how far it is worth a word, in spans of the map.
inline constexpr float full_depth = 0.15f, least_depth = 0.002f;

/// All maps; the first is the default.
std::span<const ColourMap> colour_maps();
/// The map of that key, or null.
const ColourMap* find_colour_map(std::string_view key);

/// A map in a one-dimensional texture, for the shaders: texels from `below_colour` to the map's start, then
/// along the map: the nearest texel to t is ColourMap::at(t) in 8 bits.
class ColourMapTexture {
  public:
    /// Four to an 8-bit level: looking up the nearest one is as good as interpolating, and much quicker in
    /// software.
    static constexpr int along = 1024;
    static constexpr int before = static_cast<int>(full_depth * along);

    /// Uploads the map; does nothing if they are there already.
    void upload(const ColourMap& map);
    void bind(int unit) const;

  private:
    GlTexture texture_;
    std::string_view key_;
};

}  // namespace whorl::app
