// From clicks on a field to the node that is inspected.
#pragma once

#include "app/run/session_client.h"
#include "app/run/view_settings.h"
#include "app/ui/field_viewports.h"
#include "app/ui/input_event.h"

namespace whorl::app {

/// While the inspector is open a click or a drag picks a node, of the lane under the pointer, instead of
/// painting; Shift and an arrow go to the next one.
class InspectTool {
  public:
    /// @return whether the event was meant for the inspector, and is nobody else's
    bool take(const InputEvent& event, const FieldViewports& place, SessionClient& client,
              ViewSettings& view);

  private:
    void pick(const FieldViewports& place, const FieldTile& tile, double x, double y, SessionClient& client,
              ViewSettings& view) const;

    bool picking_ = false;
};

}  // namespace whorl::app
