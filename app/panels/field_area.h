// The centre: the field's title, place, colour bar and what lies over it.
#pragma once

#include "app/panels/panel.h"
#include "app/render/field_view.h"
#include "core/scene/state.h"

namespace whorl::app {

/// Where the field is on screen, for those who draw and paint on it.
struct FieldPlacement {
    PixelRect rect;                ///< empty if the run is drawn as a curve
    double width = 0, height = 0;  ///< of the domain, length
    bool covered = false;          ///< a list or the help lies over it: do not paint

    bool drawn() const { return rect.width > 0 && rect.height > 0; }
    bool contains(double x, double y) const {
        return x >= rect.x && y >= rect.y && x < rect.x + rect.width && y < rect.y + rect.height;
    }
    /// The point under a pixel.
    WorldPoint world(double x, double y) const {
        return {(x - rect.x) / rect.width * width, (1 - (y - rect.y) / rect.height) * height};
    }
};

/// Width of the largest field that fits a centre column of this height, pixels.
float field_width_for(const Theme& theme, const Grid& grid, float height);

/// Fills the current ImGui window with all but the field itself, which lies behind it.
FieldPlacement draw_field_area(PanelContext& context);

}  // namespace whorl::app
