// Controls that draw themselves, say what they are for, and write down where they lie, in one call.
#pragma once

#include <string_view>

#include "app/render/theme.h"
#include "app/ui/background_rects.h"
#include "app/ui/event_log.h"
#include "app/ui/notifications.h"
#include "app/ui/tooltip.h"
#include "app/ui/widgets.h"

namespace whorl::app {

/// What all that is drawn in the window shares. A control's key names it in the event log; its help shows
/// where the pointer rests on it, and a warning in it says why the control is disabled.
class Ui {
  public:
    Ui(const Theme& look, EventLog& events, Notifications& messages)
        : theme(look), log(events), notifications(messages) {}

    const Theme& theme;
    EventLog& log;
    Notifications& notifications;
    Tooltip tooltip;
    BackgroundRects backgrounds;

    /// Explains and logs the last ImGui item, for controls that are none of those below.
    void explain(std::string_view key, const TooltipText& help);

    /// @param width  pixels; -FLT_MIN takes the rest of the line
    /// @return whether it was pressed
    bool button(const char* label, std::string_view key, float width, const TooltipText& help,
                bool enabled = true);
    /// A button in the accent colour: the one that is most often wanted.
    bool accent_button(const char* label, std::string_view key, float width, const TooltipText& help);
    /// A button that shows whether it is chosen.
    bool chip(const char* label, std::string_view key, bool chosen, float width, const TooltipText& help);
    /// A chip in a row of several; all but the first stand beside the one before. The help's title is its
    /// label.
    bool chip_in_row(std::string_view key, bool chosen, float width, bool first, const TooltipText& help);
    /// @return whether it was clicked
    bool check(const char* label, std::string_view key, bool value, const TooltipText& help);
    /// A line of an open list. @return whether it was taken
    bool list_item(const char* label, std::string_view key, bool chosen, const TooltipText& help);
    /// A slider for whole numbers; typed ones may lie beyond its ends. @return whether the value was changed
    bool slider(const char* id, std::string_view key, int& value, SliderRange range, const TooltipText& help);
};

}  // namespace whorl::app
