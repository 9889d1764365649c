#include "app/panels/field_header.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/number.h"

namespace whorl::app {
namespace {

/// What to do with the field where no tool says so, from all of it to what fits a narrow window.
std::span<const char* const> usual_hints(bool curves) {
    static constexpr const char* flat[] = {"Space pauses  ·  . steps  ·  R resets  ·  F12 picture  ·  H keys",
                                           "Space pauses  ·  H keys", "H keys"};
    static constexpr const char whole[] =
        "Drag to inject smoke  ·  right-drag to push  ·  shift-drag to build  ·  Space pauses  ·  F12 "
        "picture  ·  H keys";
    static constexpr const char* plane[] = {
        whole, "Drag to inject smoke  ·  right-drag to push  ·  Space pauses  ·  F12 picture  ·  H keys",
        "Drag to inject smoke  ·  right-drag to push  ·  H keys", "Drag to inject smoke  ·  H keys",
        "H keys"};
    return curves ? std::span<const char* const>(flat) : plane;
}

const char* fitting(std::span<const char* const> lines, float width) {
    for (const char* line : lines) {
        if (ImGui::CalcTextSize(line).x <= width) return line;
    }
    return "";
}

/// Chips of how lanes are compared, from the right end of the line to the left.
class Chips {
  public:
    Chips(Ui& ui, float right, float y) : ui_(ui), right_(right), y_(y) {}

    bool add(const char* label, const char* key, bool chosen, const TooltipText& help) {
        const Theme& theme = ui_.theme;
        const float width = std::ceil(ImGui::CalcTextSize(label, nullptr, true).x) + theme.px(16);
        right_ -= width;
        ImGui::SetCursorScreenPos({right_, y_});
        const bool pressed = ui_.chip(label, key, chosen, width, help);
        right_ -= theme.px(4);
        return pressed;
    }
    void gap() { right_ -= ui_.theme.px(8); }
    float left() const { return right_; }

  private:
    Ui& ui_;
    float right_, y_;
};

}  // namespace

float field_header_height(const Theme& theme, bool several) {
    return theme.title->FontSize + theme.small->FontSize + theme.px(several ? 22 : 18);
}

void FieldHeader::draw(const FieldViewports& place, std::span<const char* const> hints, ImVec2 corner,
                       float width) {
    const Theme& theme = ui_.theme;
    const View& view = fields_.view();
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushFont(theme.title);
    text(theme.palette.text, view.label);
    const float used = ImGui::GetItemRectSize().x;
    ImGui::PopFont();
    const bool reads =
        draw_reading(place, corner.x + width, corner.y + theme.px(3), width - used - theme.px(12));
    float title_end = corner.x + used + theme.px(8);
    ImGui::PushFont(theme.small);
    if (!reads && !view.unit.empty()) {
        ImGui::SetCursorScreenPos({title_end, corner.y + theme.px(4)});
        text(theme.palette.text_dim, view.unit);
        title_end += ImGui::GetItemRectSize().x + theme.px(12);
    }
    const float line = corner.y + theme.title->FontSize + theme.px(6);
    const float right = corner.x + width;
    if (hints.empty()) hints = usual_hints(run_.snapshot().grid().dimensions() == 1);
    const float left = draw_chips(place, right, line);
    if (run_.names().size() == 1) {
        ImGui::SetCursorScreenPos({corner.x, line});
        text(theme.palette.text_dim, fitting(hints, left - corner.x - theme.px(8)));
    } else if (!reads) {  // the line below is the lanes'
        const char* const hint = fitting(hints, right - title_end);
        ImGui::SetCursorScreenPos({right - ImGui::CalcTextSize(hint).x, corner.y + theme.px(4)});
        text(theme.palette.text_dim, hint);
    }
    ImGui::PopFont();
}

std::string FieldHeader::reading(const FieldViewports& place, const FieldTile& tile, ImVec2 pixel,
                                 float room) const {
    const Snapshot& s = run_.session().lanes[tile.lane];
    const WorldPoint at = place.world(tile, static_cast<double>(pixel.x), static_cast<double>(pixel.y));
    const int i = std::clamp(static_cast<int>(at.x / s.grid().h), 0, s.grid().nx - 1);
    const int j = std::clamp(static_cast<int>(at.y / s.grid().h), 0, s.grid().ny - 1);
    const Field& field = *fields_.of(tile.lane);
    const bool solid = s.solids()[static_cast<std::size_t>(j) * s.grid().nx + i] != 0;
    const std::string value = solid ? "solid" : figure(static_cast<double>(field(i, j)), 4);
    char where[48], cell[48];
    std::snprintf(where, sizeof where, "(%.2f, %.2f)  ", at.x, at.y);
    std::snprintf(cell, sizeof cell, "cell %d, %d  ", i, j);
    const std::string whole = std::string(where) + cell + value;
    return ImGui::CalcTextSize(whole.c_str()).x <= room ? whole : where + value;
}

bool FieldHeader::draw_reading(const FieldViewports& place, float right, float y, float room) const {
    const Theme& theme = ui_.theme;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const FieldTile* tile = place.at(static_cast<double>(mouse.x), static_cast<double>(mouse.y));
    if (tile == nullptr || fields_.of(tile->lane) == nullptr) return false;
    ImGui::PushFont(theme.mono);
    const std::string shown = fitted(reading(place, *tile, mouse, room), room);
    const float wide = ImGui::CalcTextSize(shown.c_str()).x;
    ImGui::SetCursorScreenPos({right - wide, y});
    text(theme.palette.text, shown);
    ImGui::PopFont();
    if (run_.names().size() == 1) return true;
    const std::string& name = run_.names().name(tile->lane);
    const float name_width = ImGui::CalcTextSize(name.c_str()).x;
    if (name_width + wide + theme.px(12) > room) return true;
    ImGui::SetCursorScreenPos({right - wide - theme.px(12) - name_width, y - theme.px(1)});
    text(theme.lane(static_cast<int>(tile->lane)), name);
    return true;
}

float FieldHeader::draw_chips(const FieldViewports& place, float right, float y) {
    Chips chips(ui_, right, y);
    if (run_.names().size() > 1) {
        const std::string& reference = run_.names().name(fields_.reference());
        const std::string less = "Every lane less " + reference +
                                 (run_.session().setup.reference == no_reference
                                      ? ", the first one; choose a reference lane to take another."
                                      : ", the reference lane, averaged to its cells.");
        if (chips.add("Difference", "compare=difference", view_.difference, {"Difference", less, "", "", ""}))
            view_.difference = !view_.difference;
        chips.gap();
        const auto mode = [&](const char* label, const char* key, Compare compare, const char* help) {
            if (chips.add(label, key, view_.compare == compare, {label, help, "", "", ""}))
                view_.compare = compare;
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
    if (!view_.window.whole()) {
        char zoom[32];
        std::snprintf(zoom, sizeof zoom, "%.0f %% ×###zoom",
                      100 / static_cast<double>(view_.window.high.x - view_.window.low.x));
        if (chips.add(zoom, "zoom-reset", false, {"Zoom", "Back to the whole domain. Key: 0", "", "", ""}))
            view_.window = {};
    }
    return chips.left();
}

}  // namespace whorl::app
