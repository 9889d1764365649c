// The left column: the program's name, the run's state, and all panels.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Fills the current ImGui window.
void draw_control_column(PanelContext& context);

}  // namespace whorl::app
