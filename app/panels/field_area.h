// The centre: the fields' places, titles, colour bar and what lies over them.
#pragma once

#include "app/panels/panel.h"
#include "app/ui/field_viewports.h"

namespace whorl::app {

/// What decides how the centre is divided.
struct FieldShape {
    Grid grid;  ///< of the first lane
    int lanes = 1;
    int tiles = 1;  ///< fields side by side
};
FieldShape field_shape(const SessionSnapshot& session, const ViewSettings& view);

/// Width that the largest fields take of a centre column of this size, pixels.
float field_width_for(const Theme& theme, const FieldShape& shape, ImVec2 room);

/// Fills the current ImGui window with all but the fields themselves, which lie behind it.
FieldViewports draw_field_area(PanelContext& context);

}  // namespace whorl::app
