// What takes input over the fields.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "app/run/services.h"
#include "app/ui/field_viewports.h"
#include "app/ui/input_event.h"

namespace whorl::app {

/// A row of the help: a key, a button or a gesture, and what it does.
struct KeyHelp {
    std::string_view keys, what;
};

class Tool {
  public:
    virtual ~Tool() = default;
    /// @return whether the event was meant for this tool, and is nobody else's
    virtual bool take(const InputEvent& event, const FieldViewports& fields) = 0;
    /// Called once a frame, before what lies over the fields is drawn.
    /// @return whether a press under the pointer would be this tool's, so that the brush does not show there
    virtual bool hover(const FieldViewports&) { return false; }
    /// The pointer is over the curves of a run in one dimension, at x, and nearest to that of a lane.
    virtual void hover_curves(double, std::size_t) {}
    /// What to do with the fields now, from all of it to what fits a narrow window. Empty leaves that to
    /// others.
    /// @param curves  the run is in one dimension
    virtual std::span<const char* const> hints(bool) const { return {}; }
    /// Called once a frame, after its events.
    virtual void end_frame() {}
};

struct ToolEntry {
    std::string_view key;
    std::span<const KeyHelp> mouse;  ///< its gestures
    std::span<const KeyHelp> keys;
    std::unique_ptr<Tool> (*make)(const Services&);
};

}  // namespace whorl::app
