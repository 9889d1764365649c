#include "app/window/window_sheet.h"

#include <algorithm>

#include "app/panels/lane_names.h"
#include "app/plot/ticks.h"

namespace whorl::app {
namespace {

/// Widths of fields, points: one is large, many are small.
float cell_width(std::size_t lanes) {
    return lanes == 1 ? 900.0f : lanes == 2 ? 620.0f : 460.0f;
}

std::string moment_line(const SessionSnapshot& moment) {
    const Grid grid = moment.setup.scene.grid();
    return std::to_string(grid.nx) + " × " + std::to_string(grid.ny) +
           " · Δt = " + figure(moment.setup.scene.dt) + " · step " + std::to_string(moment.step) +
           " · t = " + figure(moment.time);
}

/// The lanes that the window shows.
std::vector<std::size_t> shown_lanes(const SessionSnapshot& moment, const ViewState& view,
                                     std::size_t selected) {
    if (view.compare == Compare::One && selected < moment.lanes.size()) return {selected};
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < moment.lanes.size(); ++k) all.push_back(k);
    return all;
}

}  // namespace

SheetRequest sheet_of(const SessionSnapshot& moment, const ViewState& view, std::size_t selected,
                      const PictureOptions& options, std::vector<SheetPlot> plots, LaneFields& fields) {
    LaneNames names;
    names.update(moment.setup);
    fields.update(moment, *view.shown, view.difference);
    std::vector<SheetCell> cells;
    const std::vector<std::size_t> shown = shown_lanes(moment, view, selected);
    for (const std::size_t k : shown) {
        const Snapshot& lane = moment.lanes[k];
        SheetCell& cell = cells.emplace_back();
        cell.field = fields.of(k);
        cell.cells = {lane.grid.nx, lane.grid.ny};
        if (moment.lanes.size() > 1) {
            cell.title = names.name(k);
            cell.note = names.difference(k);
            cell.colour = static_cast<int>(k);
        }
        if (lane.failure) cell.stopped = "Stopped at " + *lane.failure;
        if (cell.field == nullptr) continue;
        cell.solids = lane.solids;
        cell.arrows = view.arrows ? &lane.velocity : nullptr;
    }
    const Range range = view.range.held() ? view.range.ends() : fields.span();
    SheetRequest request;
    request.rows = arranged(std::move(cells));
    request.map = &view.map();
    request.lo = range.lo;
    request.hi = range.hi;
    request.title = moment.setup.scene.title;
    request.label = bar_label(*view.shown);
    if (view.difference) request.label += "  less that of " + names.name(fields.reference());
    request.caption = moment.lanes.size() == 1 ? caption(moment.lanes.front()) : moment_line(moment);
    request.crisp = view.crisp;
    request.light = options.light;
    request.scale = static_cast<float>(options.scale);
    request.cell_width = cell_width(shown.size());
    request.plots = std::move(plots);
    return request;
}

}  // namespace whorl::app
