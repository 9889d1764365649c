// The inspector's window: a node's value taken apart.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Fills the window of the inspector, which is one of the labs.
void draw_inspector_window(PanelContext& context);

}  // namespace whorl::app
