#include "app/figure/session_sheet.h"

#include <algorithm>

#include "app/views/lane_names.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

std::string step_and_time(const SessionSnapshot& s) {
    return "step " + std::to_string(s.step) + " · t = " + figure(s.time);
}

/// The words that the descriptions of all lanes' schemes have in common.
std::string in_common(const SessionSnapshot& s) {
    constexpr std::string_view between = " · ";
    const auto words = [&](const std::string& text) {
        std::vector<std::string> all;
        for (std::size_t from = 0; from != text.npos;) {
            const std::size_t to = text.find(between, from);
            all.push_back(text.substr(from, to - from));
            from = to == text.npos ? to : to + between.size();
        }
        return all;
    };
    std::vector<std::string> common = words(describe(s.lanes.front().scene));
    for (const Snapshot& lane : s.lanes) {
        const std::vector<std::string> own = words(describe(lane.scene));
        std::erase_if(common, [&](const std::string& word) {
            return std::find(own.begin(), own.end(), word) == own.end();
        });
    }
    std::string text;
    for (const std::string& word : common) text += (text.empty() ? "" : std::string(between)) + word;
    return text;
}

/// What the lanes have in common, and the moment if it is one.
std::string caption_of(std::span<const SessionSnapshot> rows) {
    const SessionSnapshot& s = rows.front();
    const Snapshot& lane = s.lanes.front();
    if (rows.size() == 1 && s.lanes.size() == 1) return caption(lane);
    const auto agree = [&](auto&& of) {
        return std::all_of(s.lanes.begin(), s.lanes.end(),
                           [&](const Snapshot& other) { return of(other.scene) == of(lane.scene); });
    };
    std::string text;
    if (agree([](const Scene& scene) { return std::pair(scene.scalars, scene.velocity); })) {
        text = describe(lane.scene) + "\n";
    } else if (const std::string all = in_common(s); !all.empty()) {
        text = "All: " + all + "\n";
    }
    const Scene& scene = s.setup.scene;
    text += std::to_string(scene.grid().nx) + " × " + std::to_string(scene.grid().ny) +
            " · Δt = " + figure(scene.dt);
    return rows.size() == 1 ? text + " · " + step_and_time(s) : text;
}

/// Which part of the domain is shown, length units.
std::string part_of(const Grid& grid, const ViewWindow& window) {
    const auto span = [](const char* axis, float low, float high, double length) {
        return axis + (" " + figure(static_cast<double>(low) * length)) + " to " +
               figure(static_cast<double>(high) * length);
    };
    return span("x", window.low.x, window.high.x, grid.width()) + ", " +
           span("y", window.low.y, window.high.y, grid.height());
}

SheetCell cell_of(const SessionSnapshot& s, std::size_t k, const LaneNames& names, const LaneFields& fields,
                  bool arrows) {
    const Snapshot& lane = s.lanes[k];
    SheetCell cell;
    cell.field = fields.of(k);
    cell.cells = {lane.grid().nx, lane.grid().ny};
    if (s.lanes.size() > 1) {
        cell.title = names.name(k);
        cell.note = names.difference(k);
        cell.colour = static_cast<int>(k);
    }
    if (lane.failure) cell.stopped = "Stopped at " + *lane.failure;
    if (cell.field == nullptr) return cell;
    cell.solids = lane.solids();
    cell.arrows = arrows ? &lane.state.velocity : nullptr;
    return cell;
}

/// Points: one field is large, many are small, and a contact sheet's the smallest.
float usual_width(std::size_t rows, std::size_t lanes) {
    if (rows > 1) return 300;
    return lanes == 1 ? 900.0f : lanes == 2 ? 620.0f : 460.0f;
}

}  // namespace

SheetRequest sheet_of(std::span<const SessionSnapshot> rows, PictureStyle style,
                      std::deque<LaneFields>& fields) {
    SheetRequest sheet;
    std::size_t across = 0;
    Range span{};
    for (const SessionSnapshot& s : rows) {
        LaneFields& row_fields = fields.emplace_back();
        row_fields.update(s, *style.view, style.difference);
        const Range one = row_fields.span();
        span = &s == &rows.front() ? one : Range{std::min(span.lo, one.lo), std::max(span.hi, one.hi)};
        LaneNames names;
        names.update(s.setup);
        SheetRow& row = sheet.rows.emplace_back();
        row.label = step_and_time(s);
        for (std::size_t k = 0; k < s.lanes.size(); ++k) {
            if (style.alone.value_or(k) == k)
                row.cells.push_back(cell_of(s, k, names, row_fields, style.arrows));
        }
        across = std::max(across, row.cells.size());
        if (style.difference) sheet.label = "  less that of " + names.name(row_fields.reference());
    }
    if (rows.size() == 1) sheet.rows = arranged(std::move(sheet.rows.front().cells));
    const View& coloured = style.difference ? app::view("difference") : *style.view;
    sheet.map = style.map != nullptr ? style.map : find_colour_map(coloured.map);
    sheet.lo = style.range.value_or(span).lo;
    sheet.hi = style.range.value_or(span).hi;
    sheet.below = std::any_of(fields.begin(), fields.end(), [&](const LaneFields& row) {
        return row.below({sheet.lo, sheet.hi});
    });
    sheet.title = rows.front().setup.scene.title;
    sheet.label = bar_label(*style.view) + sheet.label;
    sheet.caption = caption_of(rows);
    sheet.window = style.window;
    if (!style.window.whole())
        sheet.caption += "\n" + part_of(rows.front().lanes.front().grid(), style.window);
    sheet.crisp = style.crisp || style.view->of_limiters;
    sheet.light = style.light;
    sheet.scale = style.scale;
    sheet.cell_width = style.cell_width > 0 ? style.cell_width : usual_width(rows.size(), across);
    sheet.plots = std::move(style.plots);
    return sheet;
}

}  // namespace whorl::app
