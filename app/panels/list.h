// All panels.
#pragma once

#include "app/run/panel.h"
#include "core/base/registry.h"

namespace whorl::app {

/// From top to bottom.
Registry<PanelEntry>& panels();

// A file each, but for those that hold a group of parameters and nothing else.
extern const PanelEntry run_panel, lanes_panel, picture_panel, schemes_panel, particles_panel, view_panel,
    forces_panel, brush_panel, time_panel, pressure_panel, domain_panel, labs_panel;

}  // namespace whorl::app
