#include "app/window/layout.h"

#include <algorithm>
#include <cmath>

#include "app/tutorial/lesson_panel.h"

namespace whorl::app {
namespace {

// Points. Small windows take the least of both, wide ones the most.
constexpr float margin = 12;
constexpr float controls_least = 256, controls_share = 0.215f, controls_most = 344;
constexpr float field_least = 400;  // for the lines above it
constexpr float measures_least = 240, measures_share = 0.235f, measures_usual = 388, measures_most = 620;

}  // namespace

Layout lay_out(const Theme& theme, const FieldShape& shape, float width, float height, bool reading) {
    const float gap = theme.px(width < theme.px(1200) ? 0.67f * margin : margin);
    Layout layout{};
    layout.top = gap;
    layout.height = height - 2 * gap;
    const auto share = [&](float part, float least, float most) {
        return std::floor(std::clamp(part * width, theme.px(least), theme.px(most)));
    };
    layout.controls = {gap, share(controls_share, controls_least, controls_most)};
    float plots = share(measures_share, measures_least, measures_usual);
    if (reading) plots = std::max(plots, theme.px(lesson_column_width));
    const float rest = width - layout.controls.width - 4 * gap;
    const float usable =
        std::max(field_width_for(theme, shape, {rest - plots, layout.height}), theme.px(field_least));
    plots = std::clamp(rest - usable, plots, std::max(plots, theme.px(measures_most)));
    layout.field = {layout.controls.x + layout.controls.width + gap, rest - plots};
    layout.measures = {layout.field.x + layout.field.width + gap, plots};
    return layout;
}

}  // namespace whorl::app
