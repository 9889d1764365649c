// See colour_bar.h.
#include "app/plot/colour_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/plot/ticks.h"
#include "app/render/text.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

constexpr float bar_points = 12.0f;
constexpr float tick_points = 4.0f;
constexpr float gap_points = 6.0f;

ImU32 packed(glm::vec3 colour) {
    return ImGui::ColorConvertFloat4ToU32({colour.r, colour.g, colour.b, 1.0f});
}

/// Round numbers that have room for their labels.
Ticks fitting_ticks(const Theme& theme, const ColourBar& bar, float width) {
    const double lo = std::min(bar.lo, bar.hi);
    const double hi = std::max(bar.lo, bar.hi);
    Ticks ticks;
    for (int target = 8; target >= 1; --target) {
        ticks = linear_ticks(lo, hi, target);
        float taken = 0.0f;
        for (const double value : ticks.values) {
            taken = std::max(taken, text_width(*theme.small, tick_label(value, ticks)));
        }
        const double spacing = ticks.step / (hi - lo) * static_cast<double>(width);
        if (ticks.values.size() <= 7 && static_cast<double>(taken + theme.px(14.0f)) <= spacing) break;
    }
    return ticks;
}

}  // namespace

float colour_bar_height(const Theme& theme, const ColourBar& bar) {
    const float label = bar.label.empty() ? 0.0f : theme.small->FontSize + theme.px(gap_points);
    return label + theme.px(bar_points) + theme.px(tick_points) + theme.px(2.0f) + theme.small->FontSize;
}

void draw_colour_bar(ImDrawList& list, const Theme& theme, const ColourBar& bar, ImVec2 corner, float width) {
    const ImFont& font = *theme.small;
    float y = corner.y;
    if (!bar.label.empty()) {
        const ImVec4 clip(corner.x, y, corner.x + width, y + 2.0f * font.FontSize);
        list.AddText(&font, font.FontSize, {corner.x, y}, theme.palette.text_dim, bar.label.data(),
                     bar.label.data() + bar.label.size(), 0.0f, &clip);
        y += font.FontSize + theme.px(gap_points);
    }
    const float bottom = y + theme.px(bar_points);
    if (bar.below && bar.map.shows_below(bar.lo, bar.hi)) {
        const std::string name = "< " + figure(static_cast<double>(bar.lo));
        const float taken = std::ceil(text_width(font, name)) + theme.px(gap_points);
        list.AddRectFilled({corner.x, y}, {corner.x + taken - theme.px(gap_points), bottom},
                           packed(below_colour));
        list.AddText(&font, font.FontSize, {corner.x, bottom + theme.px(tick_points + 2.0f)},
                     theme.palette.text_dim, name.data(), name.data() + name.size());
        corner.x += taken;
        width -= taken;
    }
    const std::size_t pieces = bar.map.points.size() - 1;
    for (std::size_t k = 0; k < pieces; ++k) {
        const float left = static_cast<float>(k) / static_cast<float>(pieces);
        const float right = static_cast<float>(k + 1) / static_cast<float>(pieces);
        const ImU32 from = packed(bar.map.at(left));
        const ImU32 to = packed(bar.map.at(right));
        list.AddRectFilledMultiColor({corner.x + width * left, y}, {corner.x + width * right, bottom}, from,
                                     to, to, from);
    }
    list.AddRect({corner.x, y}, {corner.x + width, bottom}, theme.palette.border, 0.0f, ImDrawFlags_None,
                 theme.thin());

    const auto mark = [&](float part, const std::string& text) {
        const float x = std::floor(corner.x + part * (width - 1.0f)) + 0.5f;
        list.AddLine({x, bottom}, {x, bottom + theme.px(tick_points)}, theme.palette.text_dim, theme.thin());
        const float wide = text_width(font, text);
        const float left = std::clamp(x - 0.5f * wide, corner.x, std::max(corner.x, corner.x + width - wide));
        list.AddText(&font, font.FontSize, {std::floor(left), bottom + theme.px(tick_points + 2.0f)},
                     theme.palette.text_dim, text.data(), text.data() + text.size());
    };
    const Ticks ticks = fitting_ticks(theme, bar, width);
    if (ticks.values.empty()) {
        mark(0.5f, bar.lo == bar.hi ? figure(static_cast<double>(bar.lo)) : "no finite range");
        return;
    }
    const double span = static_cast<double>(bar.hi) - static_cast<double>(bar.lo);
    for (const double value : ticks.values) {
        mark(static_cast<float>((value - static_cast<double>(bar.lo)) / span), tick_label(value, ticks));
    }
}

}  // namespace whorl::app
