// What is drawn over the fields.
#pragma once

#include <imgui.h>

#include <memory>
#include <string_view>
#include <vector>

#include "app/plot/plot.h"
#include "app/run/services.h"
#include "app/ui/field_viewports.h"

namespace whorl::app {

class FieldOverlay {
  public:
    virtual ~FieldOverlay() = default;
    /// @param claimed  a tool would take a press under the pointer, see Tool::hover
    virtual void draw(const FieldViewports& fields, ImDrawList& list, bool claimed) = 0;
    /// Points over the curves of a run in one dimension.
    virtual std::vector<PlotMark> marks() const { return {}; }
};

struct OverlayEntry {
    std::string_view key;
    std::unique_ptr<FieldOverlay> (*make)(const Services&);
};

}  // namespace whorl::app
