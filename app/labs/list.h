// The labs, with the tool and the overlay of the slice.
#pragma once

#include "app/run/field_overlay.h"
#include "app/run/lab.h"
#include "app/run/tool.h"

namespace whorl::app {

extern const LabEntry interpolation_lab, stencil_lab, slice_lab;
extern const ToolEntry slice_tool;
extern const OverlayEntry slice_overlay;

}  // namespace whorl::app
