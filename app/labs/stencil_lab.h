// Figures 4.2 and 4.3 of the thesis, alive: a node's particles and their weights.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Fills the current ImGui window.
void draw_stencil_lab(PanelContext& context);

}  // namespace whorl::app
