// From wheel, pointer and keys to the part of the domain that is shown, and to where one lane ends.
#pragma once

#include "app/run/view_settings.h"
#include "app/ui/field_viewports.h"
#include "app/ui/input_event.h"

namespace whorl::app {

/// Zooms about the pointer, pans, and drags the line between two lanes.
class ViewTool {
  public:
    /// @return whether the event was meant for the view, and is nobody else's
    bool take(const InputEvent& event, const FieldViewports& place, ViewSettings& view);

  private:
    enum class Drag { None, Pan, Wipe };

    bool press(const InputEvent& event, const FieldViewports& place);
    void move(const InputEvent& event, const FieldViewports& place, ViewSettings& view);
    void zoom(double notches, const FieldViewports& place, ViewSettings& view) const;

    Drag drag_ = Drag::None;
    int button_ = 0;
    std::size_t lane_ = 0;  ///< on whose tile the drag began
    double x_ = 0, y_ = 0;  ///< of the pointer, pixels
};

/// Whether a pixel is near enough to the line between two lanes to take hold of it.
bool on_wipe_line(const FieldViewports& place, double x, double y);

}  // namespace whorl::app
