// The right column: the run's measures as plots over steps, and the window's own frame time.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// What to watch of the run: what the view shows, and those of the measures in sight that are on demand.
Watch watched(const ViewSettings& view, const MeasureView& measures);

/// Fills the current ImGui window.
void draw_measure_column(PanelContext& context);

}  // namespace whorl::app
