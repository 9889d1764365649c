#include "app/panels/field_area.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/inspector/overlay.h"
#include "app/labs/slice_overlay.h"
#include "app/panels/curve_view.h"
#include "app/panels/field_header.h"
#include "app/panels/lane_tile.h"
#include "app/plot/colour_bar.h"
#include "app/ui/tiles.h"
#include "app/ui/widgets.h"

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
std::vector<std::size_t> lanes_on_screen(const PanelContext& context) {
    const SessionClient& client = context.client;
    std::vector<std::size_t> lanes;
    switch (context.view.compare) {
        case Compare::SideBySide:
            for (std::size_t k = 0; k < client.session().lanes.size(); ++k) lanes.push_back(k);
            break;
        case Compare::One:
            lanes = {context.view.peek ? client.other() : client.selected()};
            break;
        case Compare::Wipe:
            lanes = {client.selected()};
            if (client.other() != client.selected()) lanes.push_back(client.other());
            break;
    }
    return lanes;
}

/// The field of a lane as large as it gets in a place, at its centre.
FieldTile tile_in(const PanelContext& context, std::size_t lane, const PixelRect& place) {
    const Grid& grid = context.client.session().lanes[lane].grid();
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

void draw_wipe_line(const Theme& theme, const FieldViewports& place, ImDrawList& list) {
    const PixelRect& rect = place.tiles.front().rect;
    const auto top = static_cast<float>(rect.y);
    const auto bottom = static_cast<float>(rect.y + rect.height);
    const float x = *place.wipe;
    const float half = theme.px(1);
    list.AddRectFilled({x - 2 * half, top}, {x + 2 * half, bottom}, IM_COL32(0, 0, 0, 120));
    list.AddRectFilled({x - half, top}, {x + half, bottom}, theme.palette.text);
    const ImVec2 middle{x, 0.5f * (top + bottom)};
    list.AddCircleFilled(middle, theme.px(11), IM_COL32(0, 0, 0, 120));
    list.AddCircleFilled(middle, theme.px(10), theme.palette.text);
    for (const float side : {-1.0f, 1.0f}) {
        const ImVec2 tip{middle.x + side * theme.px(7), middle.y};
        const float back = tip.x - side * theme.px(4);
        list.AddTriangleFilled(tip, {back, middle.y - theme.px(4)}, {back, middle.y + theme.px(4)},
                               theme.palette.background);
    }
}

/// A ring where the brush is, on the tile under the pointer, and fainter at the same place of the others.
void draw_brush(const PanelContext& context, const FieldViewports& place, ImDrawList& list) {
    const ImGuiIO& io = ImGui::GetIO();
    if (context.view.labs.slice.grip() != SliceGrip::None) return;
    const FieldTile* under = place.at(static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
    if (under == nullptr || context.view.labs.inspector.open) return;
    const WorldPoint at =
        place.world(*under, static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
    const double shown = static_cast<double>(place.window.high.x - place.window.low.x);
    const float line = context.theme.px(1);
    const ImU32 colour =
        io.KeyShift || io.KeyCtrl ? context.theme.palette.series[1] : context.theme.palette.accent;
    for (const FieldTile& tile : place.tiles) {
        if (&tile != under && place.wipe) continue;
        const float strength = &tile == under ? 1.0f : 0.45f;
        const glm::dvec2 pixel = place.pixel(tile, at);
        const ImVec2 middle{static_cast<float>(pixel.x), static_cast<float>(pixel.y)};
        const auto radius =
            static_cast<float>(context.scene().brush.radius * tile.rect.width / (tile.width * shown));
        list.PushClipRect({static_cast<float>(tile.rect.x), static_cast<float>(tile.rect.y)},
                          {static_cast<float>(tile.rect.x + tile.rect.width),
                           static_cast<float>(tile.rect.y + tile.rect.height)},
                          true);
        list.AddCircle(middle, radius + line, faded(IM_COL32(0, 0, 0, 140), strength), 0, line);
        list.AddCircle(middle, radius, faded(colour, strength), 0, line);
        list.PopClipRect();
    }
}

/// A card of one line at the centre of `x`. @return its height
float card(const Theme& theme, ImDrawList& list, float x, float y, float room, const std::string& line,
           ImU32 edge) {
    const ImFont& font = *theme.body;
    const float pad = theme.px(11);
    const float wrap = room - 2 * pad - theme.px(6);
    const ImVec2 size =
        font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap, line.c_str(), line.c_str() + line.size());
    const float width = size.x + 2 * pad;
    const ImVec2 low{std::floor(x - 0.5f * width), std::floor(y)};
    const ImVec2 high{low.x + width, low.y + size.y + 1.4f * pad};
    list.AddRectFilled(low, high, faded(theme.palette.panel, 0.94f), theme.px(5));
    list.AddRect(low, high, edge, theme.px(5), 0, theme.px(1));
    list.AddText(&font, font.FontSize, {low.x + pad, low.y + 0.7f * pad}, theme.palette.text, line.c_str(),
                 line.c_str() + line.size(), wrap);
    return high.y - low.y;
}

void draw_notices(const PanelContext& context, const Notifications& notifications, const PixelRect& rect) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto middle = static_cast<float>(rect.x) + 0.5f * static_cast<float>(rect.width);
    const auto room = static_cast<float>(rect.width);
    const auto bottom = static_cast<float>(rect.y + rect.height) - context.theme.px(12);
    float height = 0;
    const auto& shown = notifications.shown();
    const auto draw = [&](ImDrawList& on, float y) {
        for (const Notification& notification : shown) {
            const ImU32 edge = notification.kind == Notification::Kind::Warning
                                   ? context.theme.palette.accent
                                   : context.theme.palette.border;
            y += card(context.theme, on, middle, y, room, notification.text, edge) + context.theme.px(6);
        }
        return y;
    };
    // Once aside, to learn the height.
    ImDrawList aside(ImGui::GetDrawListSharedData());
    aside._ResetForNewFrame();
    aside.PushTextureID(ImGui::GetIO().Fonts->TexID);
    aside.PushClipRectFullScreen();
    height = draw(aside, 0);
    draw(list, bottom - height);
}

void draw_failure(PanelContext& context, const PixelRect& rect) {
    const auto& failure = context.snapshot().failure;
    if (!failure) return;
    const Theme& theme = context.theme;
    ImGui::SetCursorScreenPos(
        {static_cast<float>(rect.x) + theme.px(12), static_cast<float>(rect.y) + theme.px(12)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, IM_COL32(74, 26, 22, 240));
    ImGui::PushStyleColor(ImGuiCol_Border, theme.palette.accent);
    ImGui::BeginChild("failure", {static_cast<float>(rect.width) - theme.px(24), theme.px(104)}, true,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PushFont(theme.bold);
    ImGui::TextUnformatted("The run has stopped");
    ImGui::PopFont();
    ImGui::TextWrapped("At %s. The last good state is shown.", failure->c_str());
    if (ImGui::Button("Reset")) context.client.restart();
    context.log.control("failure-reset");
    context.tooltip.item(
        theme, "failure-reset",
        {"", "Back to the start of the scene, with the schemes as they are set.", "Key: R", "", ""});
    ImGui::EndChild();
    ImGui::PopStyleColor(2);
}

/// Titles: above each field, or of two fields in one place at both ends of the line above it.
void draw_titles(PanelContext& context, const FieldViewports& place) {
    const float head = lane_title_height(context.theme);
    const auto gap = context.theme.px(16);
    for (std::size_t k = 0; k < place.tiles.size(); ++k) {
        const FieldTile& tile = place.tiles[k];
        ImVec2 corner{static_cast<float>(tile.rect.x), static_cast<float>(tile.rect.y) - head};
        auto width = static_cast<float>(tile.rect.width);
        if (place.wipe) {
            width = 0.5f * (width - gap);
            if (k == 1) corner.x += width + gap;
        }
        draw_lane_title(context, tile.lane, corner, width);
    }
}

void draw_fields(PanelContext& context, const FieldViewports& place, const PixelRect& all) {
    const Theme& theme = context.theme;
    const bool several = context.names.size() > 1;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const FieldTile& tile : place.tiles) {
        const bool marked = several && !place.wipe && place.tiles.size() > 1;
        draw_lane_frame(context, tile, marked && tile.lane == context.client.selected());
        if (several) draw_lane_state(context, tile);
        context.log.rect("field=" + std::to_string(tile.lane + 1), static_cast<float>(tile.rect.x),
                         static_cast<float>(tile.rect.y), static_cast<float>(tile.rect.width),
                         static_cast<float>(tile.rect.height));
    }
    if (several) draw_titles(context, place);
    const Range range = context.view.range.ends();
    const std::string label =
        several ? shown_quantity(context) + "  " + std::string(context.fields.view().unit) : std::string();
    const ColourBar bar{context.view.map(context.fields.view(), context.fields.difference()), range.lo,
                        range.hi, label, context.fields.below(range)};
    draw_colour_bar(list, theme, bar,
                    {static_cast<float>(all.x), static_cast<float>(all.y + all.height) + theme.px(14)},
                    static_cast<float>(all.width));
    draw_slice_line(context, place, list);
    draw_inspected(context, place, list);
    draw_brush(context, place, list);
    if (place.wipe) draw_wipe_line(theme, place, list);
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

// NOLINTNEXTLINE(readability-function-size)
FieldViewports draw_field_area(PanelContext& context) {
    const Theme& theme = context.theme;
    const SessionSnapshot& session = context.client.session();
    const FieldShape shape = field_shape(session, context.view);
    const bool several = shape.lanes > 1;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float header = field_header_height(theme, several);
    const float edge = theme.px(2);  // a column's is its border

    FieldViewports place;
    place.window = context.view.window;
    place.covered = context.view.help || context.view.labs.under_pointer ||
                    context.view.tour.under_pointer() ||
                    ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    for (const Snapshot& lane : session.lanes)
        place.cells = glm::max(place.cells, glm::ivec2(lane.grid().nx, lane.grid().ny));
    if (shape.grid.dimensions() == 1) {
        const PixelRect rect{static_cast<int>(corner.x), static_cast<int>(corner.y + header),
                             std::max(1, static_cast<int>(room.x)),
                             std::max(1, static_cast<int>(room.y - header))};
        draw_field_header(context, place, {corner.x + edge, corner.y}, room.x - 2 * edge);
        context.log.rect("field", corner.x, corner.y + header, room.x, room.y - header);
        ImGui::SetCursorScreenPos({static_cast<float>(rect.x), static_cast<float>(rect.y)});
        draw_curve_view(context, {static_cast<float>(rect.width), static_cast<float>(rect.height)});
        draw_failure(context, rect);
        draw_notices(context, context.client.notifications(), rect);
        return place;
    }

    const Tiles tiles = tiles_in(theme, shape, room);
    const float gap = tile_gap(theme);
    const float head = tile_head(theme, several);
    const float width = static_cast<float>(tiles.columns) * (tiles.width + gap) - gap;
    const float left = std::floor(corner.x + 0.5f * (room.x - width));
    const float top = std::floor(corner.y + header);
    const float height = static_cast<float>(tiles.rows) * (tiles.height + head);
    const PixelRect all{static_cast<int>(left), static_cast<int>(top), static_cast<int>(width),
                        static_cast<int>(height)};
    int k = 0;
    for (const std::size_t lane : lanes_on_screen(context)) {
        const int row = k / tiles.columns;
        const int column = k % tiles.columns;
        const float x = left + static_cast<float>(column) * (tiles.width + gap);
        const float y = top + static_cast<float>(row) * (tiles.height + head) + head;
        place.tiles.push_back(tile_in(context, lane,
                                      {static_cast<int>(x), static_cast<int>(y),
                                       static_cast<int>(tiles.width), static_cast<int>(tiles.height)}));
        if (shape.tiles > 1) ++k;
    }
    if (context.view.compare == Compare::Wipe && place.tiles.size() == 2) divide(place, context.view.wipe);

    // A narrow field leaves room for its header on both sides.
    const float header_width = std::max(width, std::min(room.x - 2 * edge, theme.px(520)));
    draw_field_header(context, place, {std::floor(corner.x + 0.5f * (room.x - header_width)), corner.y},
                      header_width);
    const PixelRect& first = place.tiles.front().rect;
    context.log.rect("field", static_cast<float>(first.x), static_cast<float>(first.y),
                     static_cast<float>(first.width), static_cast<float>(first.height));
    draw_fields(context, place, all);
    if (!several) draw_failure(context, all);
    draw_notices(context, context.client.notifications(), all);
    return place;
}

}  // namespace whorl::app
