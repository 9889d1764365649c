// The large plain rectangles behind panels and plots, cleared before ImGui draws, not drawn by it.
#pragma once

#include <imgui.h>

#include <vector>

namespace whorl::app {

/// ImGui samples its font's texture and blends for every pixel it fills. A software rasteriser takes most of
/// a frame for that where a clear takes none: so ImGui draws only the rounded ends of large rectangles.
class BackgroundRects {
  public:
    struct Rect {
        ImVec2 low, high;
        ImU32 colour;
    };

    /// A rectangle with round corners, cut to the list's clip rectangle. Draw it before what lies on it.
    void add(ImDrawList& list, ImVec2 low, ImVec2 high, float rounding, ImU32 colour);

    /// In the order they were added. Pixels from the top left.
    const std::vector<Rect>& all() const { return backgrounds_; }
    void clear() { backgrounds_.clear(); }

  private:
    std::vector<Rect> backgrounds_;
};

}  // namespace whorl::app
