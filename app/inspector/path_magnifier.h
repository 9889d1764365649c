// The ends of a node's paths, seen close: how far the tracers lie apart.
#pragma once

#include "app/ui/ui.h"
#include "core/inspect/explanation.h"

namespace whorl::app {

/// Draws a card at the cursor with the ends of the paths by Euler, by midpoint and in many small steps, and a
/// list of how far each ends from the last.
/// @param h  side of a cell, length
void draw_path_magnifier(Ui& ui, const BaseStep& step, double h);

}  // namespace whorl::app
