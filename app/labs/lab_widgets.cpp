#include "app/labs/lab_widgets.h"

#include <imgui.h>

#include <cmath>

#include "app/panels/widgets.h"

namespace whorl::app {

ImU32 interpolation_colour(const Theme& theme, std::size_t k) {
    const std::size_t hues = theme.palette.series.size();
    if (k < hues) return theme.palette.series[k];
    return k == hues ? theme.palette.text : theme.palette.text_dim;
}

float chip_width(int count) {
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    return std::floor((ImGui::GetContentRegionAvail().x + gap) / static_cast<float>(count) - gap);
}

bool lab_chip(PanelContext& context, const std::string& key, const HelpText& help, bool chosen, float width,
              bool first) {
    if (!first) ImGui::SameLine(0, std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x));
    const std::string label = fitted(help.title, width) + "##" + key;
    const bool clicked = chip(context.theme, label.c_str(), chosen, width);
    context.trace.control(key);
    context.help.item(context.theme, key, help);
    return clicked;
}

}  // namespace whorl::app
