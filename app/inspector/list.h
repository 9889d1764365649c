// The inspector: a lab with a tool and an overlay.
#pragma once

#include "app/run/field_overlay.h"
#include "app/run/lab.h"
#include "app/run/tool.h"

namespace whorl::app {

extern const LabEntry inspector_lab;
extern const ToolEntry inspect_tool;
extern const OverlayEntry inspected_overlay;

}  // namespace whorl::app
