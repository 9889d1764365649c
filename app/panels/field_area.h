// The centre: the fields' titles, colour bar and what lies over them.
#pragma once

#include "app/panels/curve_view.h"
#include "app/panels/field_header.h"
#include "app/panels/lane_tile.h"
#include "app/run/field_layers.h"

namespace whorl::app {

class FieldArea {
  public:
    FieldArea(Ui& ui, RunControl& run, ViewSettings& view, const LaneFields& fields, FieldLayers& layers)
        : ui_(ui),
          run_(run),
          view_(view),
          fields_(fields),
          layers_(layers),
          header_(ui, run, view, fields),
          lane_tiles_(ui, run, fields),
          curves_(ui, run, view, fields, layers) {}

    /// Fills the current ImGui window with all but the fields themselves, which lie behind it.
    /// @param covered  something that is drawn later lies over the fields
    /// @return where the fields are
    FieldViewports draw(bool covered);

  private:
    void draw_titles(const FieldViewports& place);
    void draw_fields(const FieldViewports& place, const PixelRect& all);

    Ui& ui_;
    RunControl& run_;
    ViewSettings& view_;
    const LaneFields& fields_;
    FieldLayers& layers_;
    FieldHeader header_;
    LaneTiles lane_tiles_;
    CurveView curves_;
};

}  // namespace whorl::app
