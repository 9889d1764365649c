// The picture of what the window shows: all lanes, or one, under one colour bar.
#pragma once

#include <vector>

#include "app/panels/file_desk.h"
#include "app/panels/view_state.h"
#include "app/render/sheet.h"
#include "app/views/lane_fields.h"

namespace whorl::app {

/// What a moment looks like in this view. The same moment gives the same sheet, whether the run played or
/// stood: a range that is not held is the moment's own.
/// @param selected  the lane that is shown where only one is
/// @param plots     beneath the fields
/// @param fields    what the request points to; must live as long, as must the moment
SheetRequest sheet_of(const SessionSnapshot& moment, const ViewState& view, std::size_t selected,
                      const PictureOptions& options, std::vector<SheetPlot> plots, LaneFields& fields);

}  // namespace whorl::app
