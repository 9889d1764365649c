// What belongs to the field of one of several lanes: its title, frame, and why it has stopped.
#pragma once

#include "app/panels/panel.h"
#include "app/ui/field_viewports.h"

namespace whorl::app {

/// Height of the line above a field, with the air around it, pixels.
float lane_title_height(const Theme& theme);

/// A line of swatch, name and what differs, which selects the lane when it is clicked.
/// @param corner  upper left of the line, `width` pixels long
void draw_lane_title(PanelContext& context, std::size_t lane, ImVec2 corner, float width);

/// A frame around the field, in the lane's colour if it is the selected one of several.
void draw_lane_frame(const PanelContext& context, const FieldTile& tile, bool marked);

/// Says over the field that its lane has stopped, or that there is nothing to show.
void draw_lane_state(const PanelContext& context, const FieldTile& tile);

}  // namespace whorl::app
