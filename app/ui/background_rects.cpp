#include "app/ui/background_rects.h"

#include <algorithm>
#include <cmath>

namespace whorl::app {

void BackgroundRects::add(ImDrawList& list, ImVec2 low, ImVec2 high, float rounding, ImU32 colour) {
    low = {std::floor(low.x), std::floor(low.y)};
    high = {std::floor(high.x), std::floor(high.y)};
    const float end = std::ceil(rounding);
    list.AddRectFilled(low, {high.x, low.y + end}, colour, rounding, ImDrawFlags_RoundCornersTop);
    list.AddRectFilled({low.x, high.y - end}, high, colour, rounding, ImDrawFlags_RoundCornersBottom);
    const ImVec2 clip_low = list.GetClipRectMin();
    const ImVec2 clip_high = list.GetClipRectMax();
    const Rect rect{{std::max(low.x, clip_low.x), std::max(low.y + end, clip_low.y)},
                    {std::min(high.x, clip_high.x), std::min(high.y - end, clip_high.y)},
                    colour};
    if (rect.low.x < rect.high.x && rect.low.y < rect.high.y) backgrounds_.push_back(rect);
}

}  // namespace whorl::app
