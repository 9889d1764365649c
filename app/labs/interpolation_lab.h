// Figures 3.5 and 3.6 of the thesis, alive: data to drag, every interpolation, and its slopes.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Fills the current ImGui window.
void draw_interpolation_lab(PanelContext& context);

}  // namespace whorl::app
