// How the centre is divided between the fields.
#pragma once

#include <imgui.h>

#include "app/render/theme.h"
#include "app/run/run_view.h"
#include "app/run/view_settings.h"
#include "app/ui/field_viewports.h"

namespace whorl::app {

/// What decides it.
struct FieldShape {
    Grid grid;  ///< of the first lane
    int lanes = 1;
    int tiles = 1;  ///< fields side by side
};
FieldShape field_shape(const SessionSnapshot& session, const ViewSettings& view);

/// Width that the largest fields take of a centre column of this size, pixels.
float field_width_for(const Theme& theme, const FieldShape& shape, ImVec2 room);

/// Where the fields go, with room for their header above and the colour bar below.
struct FieldLayout {
    FieldViewports viewports;
    PixelRect all;  ///< fields with their titles
    ImVec2 header;  ///< upper left corner
    float header_width = 0;
};
/// @param corner  upper left of the centre column, `room` large
FieldLayout lay_out_fields(const Theme& theme, const RunView& run, const ViewSettings& view, ImVec2 corner,
                           ImVec2 room);

}  // namespace whorl::app
