// The lists of what comes from several rooms: labs, tools and overlays.
#pragma once

#include "app/run/field_overlay.h"
#include "app/run/lab.h"
#include "app/run/tool.h"
#include "core/base/registry.h"

namespace whorl::app {

/// In the order of their chips.
Registry<LabEntry>& labs();

/// From the lowest to the uppermost, which is asked first: the brush takes any press that is left.
Registry<ToolEntry>& tools();

/// From the lowest to the uppermost.
Registry<OverlayEntry>& overlays();

}  // namespace whorl::app
