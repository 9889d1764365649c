// The tools over the fields, and what they draw there.
#pragma once

#include "app/run/field_overlay.h"
#include "app/run/tool.h"

namespace whorl::app {

extern const ToolEntry brush_tool, view_tool;
extern const OverlayEntry brush_ring;

}  // namespace whorl::app
