// What is said over the fields: notifications, and why the run has stopped.
#pragma once

#include "app/run/run_control.h"
#include "app/ui/field_viewports.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// The notifications on screen, at the foot of a rectangle.
void draw_notifications(const Theme& theme, const Notifications& notifications, const PixelRect& rect);

/// Why the selected lane has stopped, at the head of a rectangle; nothing if it has not.
void draw_failure(Ui& ui, RunControl& run, const PixelRect& rect);

}  // namespace whorl::app
