// The slopes of every curve in the region that keeps a cubic monotone: Figure 3.6 of the thesis.
#pragma once

#include <string>

#include "app/labs/interpolation_state.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// α and β of the curves that are shown, in the chosen interval. @param height  pixels
void draw_region_plot(Ui& ui, const InterpolationState& lab, const IntervalReports& reports, float height);

/// With two decimals and a real minus sign.
std::string signed_number(double value);

}  // namespace whorl::app
