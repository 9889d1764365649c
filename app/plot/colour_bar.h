// A colour map with numbers beneath it.
#pragma once

#include <imgui.h>

#include <string_view>

#include "app/render/colour_map.h"
#include "app/render/theme.h"

namespace whorl::app {

/// What a colour bar says.
struct ColourBar {
    const ColourMap& map;
    float lo = 0.0f;  ///< value at the left end
    float hi = 1.0f;
    std::string_view label = {};  ///< quantity and unit, above the bar; none if empty
    bool below = false;           ///< names the colour of values below the map
};

/// Height that a colour bar takes, pixels.
float colour_bar_height(const Theme& theme, const ColourBar& bar);

/// Draws a horizontal bar with round numbers beneath, which never stick out of [corner.x, corner.x + width].
void draw_colour_bar(ImDrawList& list, const Theme& theme, const ColourBar& bar, ImVec2 corner, float width);

}  // namespace whorl::app
