#include "app/panels/field_area.h"

#include <imgui.h>

#include "app/panels/field_layout.h"
#include "app/panels/field_messages.h"
#include "app/plot/colour_bar.h"

namespace whorl::app {
namespace {

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

}  // namespace

FieldViewports FieldArea::draw(bool covered) {
    FieldLayout layout =
        lay_out_fields(ui_.theme, run_, view_, ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail());
    FieldViewports& place = layout.viewports;
    place.covered =
        covered || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    const bool curves = place.tiles.empty();
    header_.draw(place, layers_.hints(curves), layout.header, layout.header_width);
    const PixelRect& first = curves ? layout.all : place.tiles.front().rect;
    const ImVec2 corner{static_cast<float>(first.x), static_cast<float>(first.y)};
    const ImVec2 size{static_cast<float>(first.width), static_cast<float>(first.height)};
    ui_.log.rect("field", corner.x, corner.y, size.x, size.y);
    if (curves) {
        ImGui::SetCursorScreenPos(corner);
        curves_.draw(size);
    } else {
        draw_fields(place, layout.all);
    }
    if (curves || run_.names().size() == 1) draw_failure(ui_, run_, layout.all);
    draw_notifications(ui_.theme, ui_.notifications, layout.all);
    return place;
}

/// Titles: above each field, or of two fields in one place at both ends of the line above it.
void FieldArea::draw_titles(const FieldViewports& place) {
    const float head = lane_title_height(ui_.theme);
    const auto gap = ui_.theme.px(16);
    for (std::size_t k = 0; k < place.tiles.size(); ++k) {
        const FieldTile& tile = place.tiles[k];
        ImVec2 corner{static_cast<float>(tile.rect.x), static_cast<float>(tile.rect.y) - head};
        auto width = static_cast<float>(tile.rect.width);
        if (place.wipe) {
            width = 0.5f * (width - gap);
            if (k == 1) corner.x += width + gap;
        }
        lane_tiles_.draw_title(tile.lane, corner, width);
    }
}

void FieldArea::draw_fields(const FieldViewports& place, const PixelRect& all) {
    const Theme& theme = ui_.theme;
    const bool several = run_.names().size() > 1;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const FieldTile& tile : place.tiles) {
        const bool marked = several && !place.wipe && place.tiles.size() > 1;
        lane_tiles_.draw_frame(tile, marked && tile.lane == run_.selected());
        if (several) lane_tiles_.draw_state(tile);
        ui_.log.rect("field=" + std::to_string(tile.lane + 1), static_cast<float>(tile.rect.x),
                     static_cast<float>(tile.rect.y), static_cast<float>(tile.rect.width),
                     static_cast<float>(tile.rect.height));
    }
    if (several) draw_titles(place);
    const Range range = view_.range.ends();
    const std::string label =
        several ? shown_quantity(fields_, run_.names()) + "  " + std::string(fields_.view().unit)
                : std::string();
    const ColourBar bar{view_.map(fields_.view(), fields_.difference()), range.lo, range.hi, label,
                        fields_.below(range)};
    draw_colour_bar(list, theme, bar,
                    {static_cast<float>(all.x), static_cast<float>(all.y + all.height) + theme.px(14)},
                    static_cast<float>(all.width));
    layers_.draw(place, list);
    if (place.wipe) draw_wipe_line(theme, place, list);
}

}  // namespace whorl::app
