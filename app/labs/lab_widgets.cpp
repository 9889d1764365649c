#include "app/labs/lab_widgets.h"

#include <imgui.h>

#include <cmath>

#include "app/render/text.h"

namespace whorl::app {

ImU32 interpolation_colour(const Theme& theme, std::size_t k) {
    const std::size_t hues = theme.palette.series.size();
    if (k < hues) return theme.palette.series[k];
    // The B-spline, which misses the points, is not in their white.
    return k == hues ? theme.palette.text_dim : theme.palette.text;
}

void swatch(const Theme& theme, ImVec2 middle, ImU32 colour, bool filled) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float half = theme.px(5);
    const ImVec2 low{middle.x - half, middle.y - half};
    const ImVec2 high{middle.x + half, middle.y + half};
    if (filled) {
        list.AddRectFilled(low, high, colour, theme.px(2));
    } else {
        list.AddRect(low, high, faded(colour, 0.7f), theme.px(2), 0, theme.thin());
    }
}

bool legend_toggle(Ui& ui, const std::string& key, const SchemeInfo& info, ImU32 colour, bool shown,
                   float width) {
    const Theme& theme = ui.theme;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = theme.body->FontSize + theme.px(8);
    const bool clicked = ImGui::InvisibleButton(key.c_str(), {width, height});
    const bool hovered = ImGui::IsItemHovered();
    ui.explain(key, {info.label, info.help, "Click to show it or leave it out", info.source, ""});
    const float left = theme.px(20);
    const float middle = std::floor(at.y + 0.5f * height);
    swatch(theme, {at.x + theme.px(9), middle}, colour, shown);
    add_text(*ImGui::GetWindowDrawList(), *theme.body, {at.x + left, middle - 0.5f * theme.body->FontSize},
             shown || hovered ? theme.palette.text : theme.palette.text_dim,
             fitted(*theme.body, info.label, width - left));
    return clicked;
}

}  // namespace whorl::app
