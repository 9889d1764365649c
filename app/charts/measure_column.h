// The right column: the run's measures as plots over steps, and the window's own frame time.
#pragma once

#include "app/charts/panel_context.h"

namespace whorl::app {

/// Those that a tab shows and that steps sum up only on demand. Limiters are watched where the view asks.
std::vector<const Measure*> measures_in_sight(MeasureTab tab);

/// Fills the current ImGui window.
void draw_measure_column(PanelContext& context);

}  // namespace whorl::app
