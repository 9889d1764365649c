// Help that appears when the pointer rests on a control.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/render/theme.h"

namespace whorl::app {

/// What the help says. Empty parts are left out.
struct TooltipText {
    std::string_view title;
    std::string_view text;
    std::string_view detail;   ///< dim: unit, range, key
    std::string_view source;   ///< where it comes from
    std::string_view warning;  ///< why the control does not apply
};

/// Waits until the pointer has rested on one thing for a moment.
class Tooltip {
  public:
    /// Call right after the item. @param key  tells items apart
    void item(const Theme& theme, std::string_view key, const TooltipText& help);
    /// Call once a frame, after everything.
    void end_frame();
    /// Is told of every item, for a test that looks for controls without help.
    std::function<void(std::string_view key, const TooltipText& help)> on_item;

  private:
    std::string hovered_;
    double since_ = 0;
    bool seen_ = false;
};

}  // namespace whorl::app
