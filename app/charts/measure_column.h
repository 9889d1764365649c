// The right column: the run's measures as plots over steps, and the window's own frame time.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Fills the current ImGui window.
void draw_measure_column(PanelContext& context);

}  // namespace whorl::app
