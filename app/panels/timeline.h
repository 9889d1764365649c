// The line of steps under the transport: where the run stands, and the way to any other step.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Draws at ImGui's cursor. A drag seeks; the run stands paused where it ends.
void draw_timeline(PanelContext& context);

/// Goes `by` steps on or back, at the last known step by stepping on.
void walk(SessionClient& client, long by);

}  // namespace whorl::app
