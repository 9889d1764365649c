// From the pointer to the slice's line on the field.
#pragma once

#include "app/labs/lab_state.h"
#include "app/ui/field_viewports.h"
#include "app/ui/input_event.h"
#include "core/session/snapshot.h"

namespace whorl::app {

/// Drags an end of the line, or all of it, while the slice's window is open.
class SliceTool {
  public:
    /// @param point pixels to a point
    /// @return whether the event was meant for the line, and is nobody else's
    bool take(const InputEvent& event, const FieldViewports& place, const SessionSnapshot& session,
              float point, SliceLab& lab);

  private:
    std::size_t lane_ = 0;  ///< on whose tile the drag began
    glm::dvec2 began_{};    ///< there, in fractions of the domain
    SliceLine before_;      ///< the line at that time
};

}  // namespace whorl::app
