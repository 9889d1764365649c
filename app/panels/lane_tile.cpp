#include "app/panels/lane_tile.h"

#include <imgui.h>

#include <cmath>

#include "app/render/text.h"

namespace whorl::app {
namespace {

constexpr ImU32 stopped_colour = IM_COL32(74, 26, 22, 240);

/// A line of text, cut with an ellipsis. @return its width
float line(ImDrawList& list, const ImFont& font, ImVec2 at, float room, ImU32 colour,
           const std::string& text) {
    const std::string shown = fitted(font, text, room);
    add_text(list, font, at, colour, shown);
    return text_width(font, shown);
}

}  // namespace

float lane_title_height(const Theme& theme) {
    return theme.body->FontSize + theme.px(12);
}

void LaneTiles::draw_title(std::size_t lane, ImVec2 corner, float width) {
    const Theme& theme = ui_.theme;
    const bool selected = lane == run_.selected();
    const std::string key = "lane-title=" + std::to_string(lane + 1);
    ImGui::SetCursorScreenPos(corner);
    if (ImGui::InvisibleButton(key.c_str(), {std::max(1.0f, width), lane_title_height(theme)}))
        run_.select(lane);
    const bool hovered = ImGui::IsItemHovered();
    title_help(lane, key);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float top = corner.y + theme.px(5);
    const float swatch = theme.px(9);
    const float middle = std::floor(top + 0.5f * theme.body->FontSize - 0.5f * swatch) + theme.px(1);
    list.AddRectFilled({corner.x, middle}, {corner.x + swatch, middle + swatch},
                       theme.lane(static_cast<int>(lane)), theme.px(2));
    float x = corner.x + swatch + theme.px(7);
    float right = corner.x + width;
    const float small_top = top + theme.body->Ascent - theme.small->Ascent;
    if (is_reference(lane)) {
        const float tag = text_width(*theme.small, "reference");
        if (width > 2.2f * tag) {
            right -= tag;
            line(list, *theme.small, {right, small_top}, tag + 1, theme.palette.accent, "reference");
            right -= theme.px(8);
        }
    }
    const ImU32 colour = selected || hovered ? theme.palette.text : theme.palette.text_dim;
    x += line(list, selected ? *theme.bold : *theme.body, {x, top}, right - x, colour,
              run_.names().name(lane));
    x += theme.px(8);
    const std::string& differs = run_.names().difference(lane);
    if (!differs.empty() && right - x > theme.px(30))
        line(list, *theme.small, {x, small_top}, right - x, theme.palette.text_dim, differs);
}

void LaneTiles::draw_frame(const FieldTile& tile, bool marked) const {
    const Theme& theme = ui_.theme;
    const float line = marked ? theme.px(2) : 1;
    const ImVec2 low{static_cast<float>(tile.rect.x) - line, static_cast<float>(tile.rect.y) - line};
    const ImVec2 high{static_cast<float>(tile.rect.x + tile.rect.width) + line,
                      static_cast<float>(tile.rect.y + tile.rect.height) + line};
    const ImU32 colour = marked ? theme.lane(static_cast<int>(tile.lane)) : theme.palette.border;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // AddRect's line has its outer edge at the corners given, half a line further in.
    const float half = 0.5f * (line - 1);
    list.AddRect({low.x + half, low.y + half}, {high.x - half, high.y - half}, colour, 0, 0, line);
}

void LaneTiles::draw_state(const FieldTile& tile) const {
    const Theme& theme = ui_.theme;
    const Snapshot& s = run_.session().lanes[tile.lane];
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto left = static_cast<float>(tile.part.x);
    const auto top = static_cast<float>(tile.part.y);
    const auto width = static_cast<float>(tile.part.width);
    if (!s.failure) {
        if (fields_.of(tile.lane) == nullptr)
            line(list, *theme.small, {left + theme.px(8), top + theme.px(8)}, width - theme.px(16),
                 theme.palette.text_dim, "Nothing to show here");
        return;
    }
    const float pad = theme.px(8);
    const ImVec2 low{left + pad, top + pad};
    const float room = width - 4 * pad;
    if (room < theme.px(40)) return;
    const std::string reason = "At " + *s.failure + ". The last good state is shown.";
    const ImFont& small = *theme.small;
    const ImVec2 size = small.CalcTextSizeA(small.FontSize, FLT_MAX, room, reason.c_str());
    const ImVec2 high{low.x + room + 2 * pad, low.y + theme.bold->FontSize + size.y + 2.5f * pad};
    list.PushClipRect({left, top}, {left + width, top + static_cast<float>(tile.part.height)}, true);
    list.AddRectFilled(low, high, stopped_colour, theme.px(5));
    list.AddRect(low, high, theme.palette.accent, theme.px(5));
    list.AddText(theme.bold, theme.bold->FontSize, {low.x + pad, low.y + pad}, theme.palette.text,
                 "This lane has stopped");
    list.AddText(&small, small.FontSize, {low.x + pad, low.y + theme.bold->FontSize + 1.5f * pad},
                 theme.palette.text, reason.c_str(), nullptr, room);
    list.PopClipRect();
}

void LaneTiles::title_help(std::size_t lane, const std::string& key) {
    const Snapshot& s = run_.session().lanes[lane];
    std::string state = std::to_string(s.grid().nx) + " × " + std::to_string(s.grid().ny);
    if (is_reference(lane)) state += " · the reference lane";
    state += lane == run_.selected() ? " · selected" : " · click to select";
    const std::string stopped = s.failure ? "Stopped at " + *s.failure : std::string();
    ui_.explain(key, {run_.names().name(lane), said_of(run_.names().difference(lane)), state, "", stopped});
}

bool LaneTiles::is_reference(std::size_t lane) const {
    if (fields_.difference()) return lane == fields_.reference();
    return static_cast<int>(lane) == run_.session().setup.reference;
}

}  // namespace whorl::app
