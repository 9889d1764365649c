#include "app/views/session_picture.h"

#include <algorithm>
#include <deque>

#include "app/plot/ticks.h"
#include "app/render/sheet.h"

namespace whorl::app {
namespace {

std::string moment(const SessionSnapshot& s) {
    return "step " + std::to_string(s.step) + " · t = " + figure(s.time);
}

std::vector<Scene> scenes_of(const SessionSnapshot& s) {
    std::vector<Scene> scenes;
    for (const Snapshot& lane : s.lanes) scenes.push_back(lane.scene);
    return scenes;
}

/// What the lanes have in common.
std::string caption_of(std::span<const SessionSnapshot> rows) {
    const SessionSnapshot& s = rows.front();
    const Snapshot& lane = s.lanes.front();
    const auto agree = [&](auto&& of) {
        return std::all_of(s.lanes.begin(), s.lanes.end(),
                           [&](const Snapshot& other) { return of(other.scene) == of(lane.scene); });
    };
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " · ") + part; };
    if (agree([](const Scene& scene) { return scene.scalars; }) &&
        agree([](const Scene& scene) { return scene.velocity; }))
        text = describe(lane.scene.scalars) + "\n";
    if (agree([](const Scene& scene) { return scene.grid(); }))
        add(std::to_string(lane.grid.nx) + " × " + std::to_string(lane.grid.ny));
    if (agree([](const Scene& scene) { return scene.dt; })) add("Δt = " + figure(lane.scene.dt));
    if (rows.size() == 1) add(moment(s));
    return text;
}

}  // namespace

Range range_of(std::span<const SessionSnapshot> rows, const View& view) {
    Field scratch;
    Range all{};
    bool first = true;
    for (const SessionSnapshot& s : rows) {
        for (const Snapshot& lane : s.lanes) {
            const Range range = view.automatic_range(lane, field_of(view, lane, scratch));
            all = first ? range : Range{std::min(all.lo, range.lo), std::max(all.hi, range.hi)};
            first = false;
        }
    }
    return all;
}

Image picture_of(std::span<const SessionSnapshot> rows, const PictureStyle& style,
                 PictureRenderer& renderer) {
    const bool one = rows.size() == 1 && rows.front().lanes.size() == 1;
    if (one) return picture_of(rows.front().lanes.front(), style, renderer);
    std::deque<Field> scratch;  // its fields stay where they are
    std::vector<SheetRow> sheet_rows;
    for (const SessionSnapshot& s : rows) {
        const std::vector<std::string> names = titles(s.setup);
        const std::vector<std::string> notes = differences(scenes_of(s));
        SheetRow row{.label = moment(s), .cells = {}};
        for (std::size_t k = 0; k < s.lanes.size(); ++k) {
            const Snapshot& lane = s.lanes[k];
            SheetCell& cell = row.cells.emplace_back();
            cell.field = &field_of(*style.view, lane, scratch.emplace_back());
            cell.solids = lane.solids;
            cell.arrows = style.arrows ? &lane.velocity : nullptr;
            cell.cells = {lane.grid.nx, lane.grid.ny};
            cell.title = names[k];
            cell.note = notes[k] == names[k] ? "" : notes[k];
            cell.colour = static_cast<int>(k);
            cell.stopped = lane.failure.value_or("");
        }
        sheet_rows.push_back(std::move(row));
    }
    SheetRequest sheet = request(style, style.range ? *style.range : range_of(rows, *style.view), true);
    sheet.rows = rows.size() == 1 ? arranged(std::move(sheet_rows.front().cells)) : std::move(sheet_rows);
    sheet.title = rows.front().setup.scene.title;
    sheet.caption = caption_of(rows);
    return renderer.render(sheet);
}

}  // namespace whorl::app
