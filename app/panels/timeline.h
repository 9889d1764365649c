// The line of steps under the transport: where the run stands, and the way to any other step.
#pragma once

#include "app/run/run_control.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// Draws at ImGui's cursor. A drag seeks; the run stands paused where it ends.
void draw_timeline(Ui& ui, RunControl& run);

}  // namespace whorl::app
