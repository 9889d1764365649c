// The curves along a line through the field, of all lanes or of all interpolations.
#pragma once

#include "app/panels/field_placement.h"
#include "app/panels/panel.h"

namespace whorl::app {

/// Fills the current ImGui window.
void draw_slice_window(PanelContext& context);

/// The line over each field, while the window is open.
void draw_slice_line(const PanelContext& context, const FieldPlacement& place, ImDrawList& list);

}  // namespace whorl::app
