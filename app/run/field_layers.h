// All tools and overlays of the fields.
#pragma once

#include <vector>

#include "app/run/field_overlay.h"
#include "app/run/tool.h"

namespace whorl::app {

class FieldLayers {
  public:
    /// Tools lie over each other: the one that was added last is asked first.
    void add(const ToolEntry& entry, const Services& services) {
        tools_.insert(tools_.begin(), entry.make(services));
    }
    /// Overlays are drawn in the order in which they were added.
    void add(const OverlayEntry& entry, const Services& services) {
        overlays_.push_back(entry.make(services));
    }

    /// @return whether a tool took the event
    bool take(const InputEvent& event, const FieldViewports& fields);
    void end_frame();

    void draw(const FieldViewports& fields, ImDrawList& list);
    /// Over curves, see FieldOverlay and Tool.
    std::vector<PlotMark> marks() const;
    void hover_curves(double x, std::size_t lane);
    /// What a tool says of what to do with the fields; empty if none does.
    std::span<const char* const> hints(bool curves) const;

  private:
    std::vector<std::unique_ptr<Tool>> tools_;  ///< the topmost first
    std::vector<std::unique_ptr<FieldOverlay>> overlays_;
};

}  // namespace whorl::app
