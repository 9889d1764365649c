// The interpolations by name, with their numbers in the chosen interval.
#pragma once

#include "app/labs/interpolation_state.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// Pixels.
float interpolation_table_height(const Theme& theme);

/// The legend, which toggles the curves, and the numbers of each in the chosen interval.
void draw_interpolation_table(Ui& ui, InterpolationState& lab, const IntervalReports& reports);

}  // namespace whorl::app
