// What a panel is, and the one table of them.
#pragma once

#include <span>

#include "app/charts/measure_view.h"
#include "app/render/theme.h"
#include "app/run/file_requests.h"
#include "app/run/history.h"
#include "app/run/session_client.h"
#include "app/run/view_settings.h"
#include "app/ui/background_rects.h"
#include "app/ui/event_log.h"
#include "app/ui/frame_log.h"
#include "app/ui/tooltip.h"
#include "app/views/lane_fields.h"
#include "app/views/lane_names.h"

namespace whorl::app {

/// What a panel sees and where it asks: it reads the run, changes the view, and sends commands.
struct PanelContext {
    const Theme& theme;
    SessionClient& client;  ///< the run: its newest snapshot, the scene as chosen, and what to ask of it
    ViewSettings& view;
    MeasureView& measures;
    FileRequests& files;
    const History& history;
    const FrameLog& frames;
    const LaneFields& fields;  ///< what the chosen view shows of every lane
    const LaneNames& names;    ///< of the newest snapshot's lanes
    Tooltip& tooltip;
    EventLog& log;
    BackgroundRects& backgrounds;

    const Snapshot& snapshot() const { return client.snapshot(); }
    const Scene& scene() const { return client.scene(); }
};

/// A titled group of controls in the left column.
struct Panel {
    const char* title;
    void (*draw)(PanelContext&);
    bool open = true;  ///< at the start
};

/// All panels, from top to bottom.
std::span<const Panel> panels();

// One file each.
void draw_run_panel(PanelContext&);
void draw_lanes_panel(PanelContext&);
void draw_schemes_panel(PanelContext&);
void draw_particles_panel(PanelContext&);
void draw_view_panel(PanelContext&);
void draw_picture_panel(PanelContext&);
void draw_forces_panel(PanelContext&);
void draw_brush_panel(PanelContext&);
void draw_time_panel(PanelContext&);
void draw_pressure_panel(PanelContext&);
void draw_domain_panel(PanelContext&);
void draw_labs_panel(PanelContext&);

}  // namespace whorl::app
