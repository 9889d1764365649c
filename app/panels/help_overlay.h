// The keys and gestures, over everything.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Draws the help if it is on; a click anywhere closes it.
void draw_help_overlay(PanelContext& context);

}  // namespace whorl::app
