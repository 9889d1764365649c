#include "app/window/window_sheet.h"

#include <algorithm>

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

}  // namespace

WindowSheet sheet_of(const SessionSnapshot& moment, const ViewState& view, std::size_t selected,
                     const PictureOptions& options, std::vector<SheetPlot> plots) {
    WindowSheet sheet;
    SheetRequest& request = sheet.request;
    sheet.scratch.resize(moment.lanes.size());
    const std::vector<std::string> names = titles(moment.setup);
    std::vector<SheetCell> cells;
    Range range = view.range.ends();
    bool first = !view.range.held();
    for (std::size_t k = 0; k < moment.lanes.size(); ++k) {
        const Snapshot& lane = moment.lanes[k];
        SheetCell cell;
        cell.field = view.shown->field(lane, sheet.scratch[k]);
        cell.cells = {lane.grid.nx, lane.grid.ny};
        if (moment.lanes.size() > 1) {
            cell.title = names[k];
            cell.colour = static_cast<int>(k);
        }
        if (lane.failure) cell.stopped = "Stopped at " + *lane.failure;
        if (cell.field != nullptr) {
            cell.solids = lane.solids;
            cell.arrows = view.arrows ? &lane.velocity : nullptr;
            if (!view.range.held()) {
                const Range span = view.shown->automatic_range(lane, *cell.field);
                range = first ? span : Range{std::min(range.lo, span.lo), std::max(range.hi, span.hi)};
                first = false;
            }
        }
        cells.push_back(std::move(cell));
    }
    const Snapshot& only = moment.lanes[std::min(selected, moment.lanes.size() - 1)];
    request.rows = arranged(std::move(cells));
    request.map = &view.map();
    request.lo = range.lo;
    request.hi = range.hi;
    request.title = moment.setup.scene.title;
    request.label = bar_label(*view.shown);
    request.caption = moment.lanes.size() == 1 ? caption(only) : moment_line(moment);
    request.crisp = view.crisp;
    request.light = options.light;
    request.scale = static_cast<float>(options.scale);
    request.cell_width = cell_width(moment.lanes.size());
    if (options.plots) request.plots = std::move(plots);
    return sheet;
}

}  // namespace whorl::app
