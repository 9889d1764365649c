// The curves along a line through the field, of all lanes or of all interpolations.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Fills the current ImGui window.
void draw_slice_window(PanelContext& context);

}  // namespace whorl::app
