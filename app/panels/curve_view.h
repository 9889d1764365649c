// A one-dimensional run: a curve for every lane, over the exact one.
#pragma once

#include "app/run/field_layers.h"
#include "app/run/run_view.h"
#include "app/run/view_settings.h"
#include "app/ui/ui.h"
#include "app/views/lane_fields.h"

namespace whorl::app {

class CurveView {
  public:
    CurveView(Ui& ui, const RunView& run, const ViewSettings& view, const LaneFields& fields,
              FieldLayers& layers)
        : ui_(ui), run_(run), view_(view), fields_(fields), layers_(layers) {}

    /// Draws at ImGui's cursor.
    void draw(ImVec2 size);

  private:
    Ui& ui_;
    const RunView& run_;
    const ViewSettings& view_;
    const LaneFields& fields_;
    FieldLayers& layers_;
};

}  // namespace whorl::app
