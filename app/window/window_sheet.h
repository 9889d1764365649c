// The picture of what the window shows: all lanes under one colour bar.
#pragma once

#include <vector>

#include "app/panels/file_desk.h"
#include "app/panels/view_state.h"
#include "app/render/sheet.h"

namespace whorl::app {

/// A request and the fields that it points to.
struct WindowSheet {
    std::vector<Field> scratch;  ///< of views that are worked out, one a lane
    SheetRequest request;
};

/// What a moment looks like in this view. The same moment gives the same sheet, whether the run played or
/// stood: a range that is not held is the moment's own.
/// @param selected  the lane that is shown where only one is
/// @param plots     beneath the fields, if the options ask for them
WindowSheet sheet_of(const SessionSnapshot& moment, const ViewState& view, std::size_t selected,
                     const PictureOptions& options, std::vector<SheetPlot> plots);

}  // namespace whorl::app
