#include "app/panels/field_header.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/ui/widgets.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

/// What to do with the field, from all of it to what fits a narrow window.
const char* hints(const Snapshot& s, bool inspects, float width) {
    constexpr const char* inspecting[] = {
        "Click a cell to see the sum behind it  ·  wheel goes closer  ·  0 shows all  ·  I ends it",
        "Click a cell  ·  wheel goes closer  ·  I ends it", "Click a cell  ·  I ends it", "Click a cell"};
    constexpr const char* flat[] = {"Space pauses  ·  . steps  ·  R resets  ·  F12 picture  ·  H keys",
                                    "Space pauses  ·  H keys", "H keys"};
    constexpr const char* all_of_plane =
        "Drag to inject smoke  ·  right-drag to push  ·  shift-drag to build  ·  Space pauses"
        "  ·  F12 picture  ·  H keys";
    constexpr const char* plane[] = {
        all_of_plane,
        "Drag to inject smoke  ·  right-drag to push  ·  Space pauses  ·  F12 picture  ·  H keys",
        "Drag to inject smoke  ·  right-drag to push  ·  H keys", "Drag to inject smoke  ·  H keys",
        "H keys"};
    std::span<const char* const> all = plane;
    const bool is_flat = s.grid().dimensions() == 1;
    if (is_flat) all = flat;
    // Curves have no zoom.
    if (inspects) all = std::span<const char* const>(inspecting).subspan(is_flat ? 2 : 0);
    for (const char* line : all) {
        if (ImGui::CalcTextSize(line).x <= width) return line;
    }
    return "";
}

/// Position, cell and value under a pixel, without the cell where there is no room for it.
std::string reading(const PanelContext& context, const FieldViewports& place, const FieldTile& tile,
                    ImVec2 pixel, float room) {
    const Snapshot& s = context.client.session().lanes[tile.lane];
    const WorldPoint at = place.world(tile, static_cast<double>(pixel.x), static_cast<double>(pixel.y));
    const int i = std::clamp(static_cast<int>(at.x / s.grid().h), 0, s.grid().nx - 1);
    const int j = std::clamp(static_cast<int>(at.y / s.grid().h), 0, s.grid().ny - 1);
    const Field& field = *context.fields.of(tile.lane);
    const bool solid = s.solids()[static_cast<std::size_t>(j) * s.grid().nx + i] != 0;
    const std::string value = solid ? "solid" : figure(static_cast<double>(field(i, j)), 4);
    char where[48], cell[48];
    std::snprintf(where, sizeof where, "(%.2f, %.2f)  ", at.x, at.y);
    std::snprintf(cell, sizeof cell, "cell %d, %d  ", i, j);
    const std::string whole = std::string(where) + cell + value;
    return ImGui::CalcTextSize(whole.c_str()).x <= room ? whole : where + value;
}

/// The reading at the right end of a line, behind the name of its lane where there is room for both.
/// @return whether the pointer is on a field
bool draw_reading(const PanelContext& context, const FieldViewports& place, float right, float y,
                  float room) {
    const Theme& theme = context.theme;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const FieldTile* tile = place.at(static_cast<double>(mouse.x), static_cast<double>(mouse.y));
    if (tile == nullptr || context.fields.of(tile->lane) == nullptr) return false;
    ImGui::PushFont(theme.mono);
    const std::string shown = fitted(reading(context, place, *tile, mouse, room), room);
    const float wide = ImGui::CalcTextSize(shown.c_str()).x;
    ImGui::SetCursorScreenPos({right - wide, y});
    text(theme.palette.text, shown);
    ImGui::PopFont();
    if (context.names.size() == 1) return true;
    const std::string& name = context.names.name(tile->lane);
    const float name_width = ImGui::CalcTextSize(name.c_str()).x;
    if (name_width + wide + theme.px(12) > room) return true;
    ImGui::SetCursorScreenPos({right - wide - theme.px(12) - name_width, y - theme.px(1)});
    text(theme.lane(static_cast<int>(tile->lane)), name);
    return true;
}

/// Chips of how lanes are compared, from the right end of the line to the left.
class Chips {
  public:
    Chips(PanelContext& context, float right, float y) : context_(context), right_(right), y_(y) {}

    bool add(const char* label, const char* key, bool chosen, const TooltipText& help) {
        const Theme& theme = context_.theme;
        const float width = std::ceil(ImGui::CalcTextSize(label, nullptr, true).x) + theme.px(16);
        right_ -= width;
        ImGui::SetCursorScreenPos({right_, y_});
        const bool pressed = chip(theme, label, chosen, width);
        context_.log.control(key);
        context_.tooltip.item(theme, key, help);
        right_ -= theme.px(4);
        return pressed;
    }
    void gap() { right_ -= context_.theme.px(8); }
    float left() const { return right_; }

  private:
    PanelContext& context_;
    float right_, y_;
};

/// @return the left end of what was drawn
float draw_chips(PanelContext& context, const FieldViewports& place, float right, float y) {
    ViewSettings& view = context.view;
    Chips chips(context, right, y);
    if (context.names.size() > 1) {
        const std::string& reference = context.names.name(context.fields.reference());
        const std::string less = "Every lane less " + reference +
                                 (context.client.session().setup.reference == no_reference
                                      ? ", the first one; choose a reference lane to take another."
                                      : ", the reference lane, averaged to its cells.");
        if (chips.add("Difference", "compare=difference", view.difference, {"Difference", less, "", "", ""}))
            view.difference = !view.difference;
        chips.gap();
        const auto mode = [&](const char* label, const char* key, Compare compare, const char* help) {
            if (chips.add(label, key, view.compare == compare, {label, help, "", "", ""}))
                view.compare = compare;
        };
        if (!place.tiles.empty()) {
            mode("Wipe", "compare=wipe", Compare::Wipe,
                 "The selected lane left of a line, the lane selected before right of it. Drag the line.");
            mode("One", "compare=one", Compare::One,
                 "The selected lane alone. Hold Tab to see the lane selected before in its place.");
            mode("Side by side", "compare=side-by-side", Compare::SideBySide, "All lanes.");
            chips.gap();
        }
    }
    if (!view.window.whole()) {
        char zoom[32];
        std::snprintf(zoom, sizeof zoom, "%.0f %% ×###zoom",
                      100 / static_cast<double>(view.window.high.x - view.window.low.x));
        if (chips.add(zoom, "zoom-reset", false, {"Zoom", "Back to the whole domain. Key: 0", "", "", ""}))
            view.window = {};
    }
    return chips.left();
}

}  // namespace

std::string shown_quantity(const PanelContext& context) {
    std::string words(context.fields.view().label);
    if (context.fields.difference())
        words += " less that of " + context.names.name(context.fields.reference());
    return words;
}

float field_header_height(const Theme& theme, bool several) {
    return theme.title->FontSize + theme.small->FontSize + theme.px(several ? 22 : 18);
}

void draw_field_header(PanelContext& context, const FieldViewports& place, ImVec2 corner, float width) {
    const Theme& theme = context.theme;
    const View& view = context.fields.view();
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushFont(theme.title);
    text(theme.palette.text, view.label);
    const float used = ImGui::GetItemRectSize().x;
    ImGui::PopFont();
    const bool reads =
        draw_reading(context, place, corner.x + width, corner.y + theme.px(3), width - used - theme.px(12));
    float title_end = corner.x + used + theme.px(8);
    ImGui::PushFont(theme.small);
    if (!reads && !view.unit.empty()) {
        ImGui::SetCursorScreenPos({title_end, corner.y + theme.px(4)});
        text(theme.palette.text_dim, view.unit);
        title_end += ImGui::GetItemRectSize().x + theme.px(12);
    }
    const float line = corner.y + theme.title->FontSize + theme.px(6);
    const float right = corner.x + width;
    const bool inspecting = context.view.labs.inspector.open;
    const float left = draw_chips(context, place, right, line);
    if (context.names.size() == 1) {
        ImGui::SetCursorScreenPos({corner.x, line});
        text(theme.palette.text_dim, hints(context.snapshot(), inspecting, left - corner.x - theme.px(8)));
    } else if (!reads) {  // the line below is the lanes'
        const char* const hint = hints(context.snapshot(), inspecting, right - title_end);
        ImGui::SetCursorScreenPos({right - ImGui::CalcTextSize(hint).x, corner.y + theme.px(4)});
        text(theme.palette.text_dim, hint);
    }
    ImGui::PopFont();
}

}  // namespace whorl::app
