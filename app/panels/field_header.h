// The lines above the fields: what is shown, the value under the pointer, and how lanes are compared.
#pragma once

#include <span>
#include <string>

#include "app/run/run_view.h"
#include "app/run/view_settings.h"
#include "app/ui/field_viewports.h"
#include "app/ui/ui.h"
#include "app/views/lane_fields.h"

namespace whorl::app {

/// With the air below it, pixels.
float field_header_height(const Theme& theme, bool several);

class FieldHeader {
  public:
    FieldHeader(Ui& ui, const RunView& run, ViewSettings& view, const LaneFields& fields)
        : ui_(ui), run_(run), view_(view), fields_(fields) {}

    /// Draws at `corner`, `width` pixels wide.
    /// @param hints  what to do with the fields, from all of it to what fits a narrow window; empty for what
    /// is usual
    void draw(const FieldViewports& place, std::span<const char* const> hints, ImVec2 corner, float width);

  private:
    /// Position, cell and value under a pixel, without the cell where there is no room for it.
    std::string reading(const FieldViewports& place, const FieldTile& tile, ImVec2 pixel, float room) const;
    /// The reading at the right end of a line, behind the name of its lane where there is room for both.
    /// @return whether the pointer is on a field
    bool draw_reading(const FieldViewports& place, float right, float y, float room) const;
    /// @return the left end of what was drawn
    float draw_chips(const FieldViewports& place, float right, float y);

    Ui& ui_;
    const RunView& run_;
    ViewSettings& view_;
    const LaneFields& fields_;
};

}  // namespace whorl::app
