// What belongs to the field of one of several lanes: its title, frame, and why it has stopped.
#pragma once

#include "app/run/run_control.h"
#include "app/ui/field_viewports.h"
#include "app/ui/ui.h"
#include "app/views/lane_fields.h"

namespace whorl::app {

/// Height of the line above a field, with the air around it, pixels.
float lane_title_height(const Theme& theme);

class LaneTiles {
  public:
    LaneTiles(Ui& ui, RunControl& run, const LaneFields& fields) : ui_(ui), run_(run), fields_(fields) {}

    /// A line of swatch, name and what differs, which selects the lane when it is clicked.
    /// @param corner  upper left of the line, `width` pixels long
    void draw_title(std::size_t lane, ImVec2 corner, float width);
    /// A frame around the field, in the lane's colour if it is the selected one of several.
    void draw_frame(const FieldTile& tile, bool marked) const;
    /// Says over the field that its lane has stopped, or that there is nothing to show.
    void draw_state(const FieldTile& tile) const;

  private:
    bool is_reference(std::size_t lane) const;
    void title_help(std::size_t lane, const std::string& key);

    Ui& ui_;
    RunControl& run_;
    const LaneFields& fields_;
};

}  // namespace whorl::app
