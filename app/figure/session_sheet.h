// Sheets of a session: its lanes at one step, or a contact sheet with a row a step and a column a lane.
#pragma once

#include <deque>
#include <optional>

#include "app/figure/sheet.h"
#include "app/views/lane_fields.h"

namespace whorl::app {

/// How to draw lanes.
struct PictureStyle {
    const View* view = nullptr;
    bool difference = false;             ///< each lane less the reference lane
    std::optional<std::size_t> alone{};  ///< this lane only
    const ColourMap* map = nullptr;      ///< null takes the view's own
    std::optional<Range> range{};        ///< nothing takes what all fields span
    ViewWindow window{};                 ///< part of the domain that is shown
    bool crisp = false;
    bool light = false;
    bool arrows = false;
    float cell_width = 0;  ///< of a field, about, points; 0 takes what suits their number
    float scale = 1;       ///< pixels to a point
    std::vector<SheetPlot> plots{};
};

/// The lanes of one moment side by side, or of several in rows, with one range and one colour bar. A lane
/// that has no such field leaves its place empty.
/// @param rows    of the same lanes; at least one
/// @param fields  what the request points to, a row each; must live as long, as must the rows
SheetRequest sheet_of(std::span<const SessionSnapshot> rows, PictureStyle style,
                      std::deque<LaneFields>& fields);

}  // namespace whorl::app
