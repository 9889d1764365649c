// What a page of the measures sees and where it asks.
#pragma once

#include "app/charts/measure_view.h"
#include "app/run/right_column.h"
#include "app/run/run_control.h"
#include "app/run/view_settings.h"
#include "app/ui/frame_log.h"
#include "app/ui/ui.h"

namespace whorl::app {

struct PanelContext {
    const Theme& theme;
    EventLog& log;
    Tooltip& tooltip;
    BackgroundRects& backgrounds;
    RunControl& client;
    const ViewSettings& view;
    RightColumn& right_column;
    MeasureView& measures;
    const History& history;
    const FrameLog& frames;
    const LaneNames& names;

    const Snapshot& snapshot() const { return client.snapshot(); }
};

}  // namespace whorl::app
