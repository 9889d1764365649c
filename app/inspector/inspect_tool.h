// From clicks on a field to the node that is inspected.
#pragma once

#include "app/inspector/inspection.h"
#include "app/run/run_control.h"
#include "app/run/tool.h"
#include "app/run/view_settings.h"

namespace whorl::app {

/// While the inspector is open a click or a drag picks a node, of the lane under the pointer, instead of
/// painting; Shift and an arrow go to the next one; and without a brush the wheel is free to zoom.
class InspectTool final : public Tool {
  public:
    InspectTool(RunControl& run, ViewSettings& view, Inspection& inspection)
        : run_(run), view_(view), inspection_(inspection) {}

    bool take(const InputEvent& event, const FieldViewports& fields) override;
    bool hover(const FieldViewports&) override { return inspection_.open; }
    void hover_curves(double x, std::size_t lane) override;
    std::span<const char* const> hints(bool curves) const override;

  private:
    void pick(const FieldViewports& fields, const FieldTile& tile, double x, double y) const;

    RunControl& run_;
    ViewSettings& view_;
    Inspection& inspection_;
    bool picking_ = false;
};

}  // namespace whorl::app
