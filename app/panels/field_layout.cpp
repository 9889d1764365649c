#include "app/panels/field_layout.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/common.hpp>

#include "app/panels/field_header.h"
#include "app/panels/lane_tile.h"
#include "app/ui/tiles.h"

namespace whorl::app {
namespace {

/// Below the fields, pixels; the bar of several lanes says what it measures.
float bar_space(const Theme& theme, bool several) {
    return theme.px(16) + theme.px(12 + 6) + theme.small->FontSize + theme.px(6) +
           (several ? theme.small->FontSize + theme.px(6) : 0);
}

float aspect(const Grid& grid) {
    return static_cast<float>(grid.ny) / static_cast<float>(grid.nx);
}

float tile_gap(const Theme& theme) {
    return theme.px(12);
}

/// Above each field of several lanes, pixels.
float tile_head(const Theme& theme, bool several) {
    return several ? lane_title_height(theme) : 0;
}

Tiles tiles_in(const Theme& theme, const FieldShape& shape, ImVec2 room) {
    const bool several = shape.lanes > 1;
    const float height = room.y - field_header_height(theme, several) - bar_space(theme, several);
    const float frame = theme.px(2);
    return largest_tiles(shape.tiles, aspect(shape.grid), room.x - 2 * frame, height, tile_gap(theme),
                         tile_head(theme, several));
}

/// The lanes whose fields are on screen, in order.
std::vector<std::size_t> lanes_on_screen(const RunView& run, const ViewSettings& view) {
    std::vector<std::size_t> lanes;
    switch (view.compare) {
        case Compare::SideBySide:
            for (std::size_t k = 0; k < run.session().lanes.size(); ++k) lanes.push_back(k);
            break;
        case Compare::One:
            lanes = {view.peek ? run.other() : run.selected()};
            break;
        case Compare::Wipe:
            lanes = {run.selected()};
            if (run.other() != run.selected()) lanes.push_back(run.other());
            break;
    }
    return lanes;
}

/// The field of a lane as large as it gets in a place, at its centre.
FieldTile tile_in(const RunView& run, std::size_t lane, const PixelRect& place) {
    const Grid& grid = run.session().lanes[lane].grid();
    const float high = aspect(grid) * static_cast<float>(place.width);
    FieldTile tile{lane, place, place, grid.width(), grid.height()};
    if (high > static_cast<float>(place.height) + 1) {
        tile.rect.width = std::max(1, static_cast<int>(static_cast<float>(place.height) / aspect(grid)));
        tile.rect.x += (place.width - tile.rect.width) / 2;
    } else if (high < static_cast<float>(place.height) - 1) {
        tile.rect.height = std::max(1, static_cast<int>(high));
        tile.rect.y += (place.height - tile.rect.height) / 2;
    }
    tile.part = tile.rect;
    return tile;
}

/// Two fields in one place: the first ends and the second begins at the line.
void divide(FieldViewports& place, float wipe) {
    FieldTile& left = place.tiles[0];
    FieldTile& right = place.tiles[1];
    const int x = left.rect.x + static_cast<int>(std::lround(wipe * static_cast<float>(left.rect.width)));
    left.part.width = x - left.rect.x;
    right.part.width -= x - right.part.x;
    right.part.x = x;
    place.wipe = static_cast<float>(x);
}

}  // namespace

FieldShape field_shape(const SessionSnapshot& session, const ViewSettings& view) {
    const auto lanes = static_cast<int>(session.lanes.size());
    return {session.lanes.front().grid(), lanes, view.compare == Compare::SideBySide ? lanes : 1};
}

float field_width_for(const Theme& theme, const FieldShape& shape, ImVec2 room) {
    if (shape.grid.dimensions() == 1) return FLT_MAX;
    const Tiles tiles = tiles_in(theme, shape, room);
    return static_cast<float>(tiles.columns) * (tiles.width + tile_gap(theme)) - tile_gap(theme) +
           2 * theme.px(2);
}

FieldLayout lay_out_fields(const Theme& theme, const RunView& run, const ViewSettings& view, ImVec2 corner,
                           ImVec2 room) {
    const FieldShape shape = field_shape(run.session(), view);
    const bool several = shape.lanes > 1;
    const float header = field_header_height(theme, several);
    const float edge = theme.px(2);  // a column's is its border
    FieldLayout layout;
    layout.viewports.window = view.window;
    for (const Snapshot& lane : run.session().lanes)
        layout.viewports.cells = glm::max(layout.viewports.cells, glm::ivec2(lane.grid().nx, lane.grid().ny));
    if (shape.grid.dimensions() == 1) {
        layout.all = {static_cast<int>(corner.x), static_cast<int>(corner.y + header),
                      std::max(1, static_cast<int>(room.x)), std::max(1, static_cast<int>(room.y - header))};
        layout.header = {corner.x + edge, corner.y};
        layout.header_width = room.x - 2 * edge;
        return layout;
    }

    const Tiles tiles = tiles_in(theme, shape, room);
    const float gap = tile_gap(theme);
    const float head = tile_head(theme, several);
    const float width = static_cast<float>(tiles.columns) * (tiles.width + gap) - gap;
    const float left = std::floor(corner.x + 0.5f * (room.x - width));
    const float top = std::floor(corner.y + header);
    const float height = static_cast<float>(tiles.rows) * (tiles.height + head);
    layout.all = {static_cast<int>(left), static_cast<int>(top), static_cast<int>(width),
                  static_cast<int>(height)};
    int k = 0;
    for (const std::size_t lane : lanes_on_screen(run, view)) {
        const int row = k / tiles.columns;
        const int column = k % tiles.columns;
        const float x = left + static_cast<float>(column) * (tiles.width + gap);
        const float y = top + static_cast<float>(row) * (tiles.height + head) + head;
        layout.viewports.tiles.push_back(
            tile_in(run, lane,
                    {static_cast<int>(x), static_cast<int>(y), static_cast<int>(tiles.width),
                     static_cast<int>(tiles.height)}));
        if (shape.tiles > 1) ++k;
    }
    if (view.compare == Compare::Wipe && layout.viewports.tiles.size() == 2)
        divide(layout.viewports, view.wipe);

    // A narrow field leaves room for its header on both sides.
    layout.header_width = std::max(width, std::min(room.x - 2 * edge, theme.px(520)));
    layout.header = {std::floor(corner.x + 0.5f * (room.x - layout.header_width)), corner.y};
    return layout;
}

}  // namespace whorl::app
