// What the inspector draws over a field: where a node's value comes from.
#pragma once

#include "app/inspector/inspection.h"
#include "app/render/theme.h"
#include "app/run/field_overlay.h"
#include "app/run/run_view.h"

namespace whorl::app {

/// Colours of the paths along the flow, over any colour map.
struct PathColours {
    ImU32 scheme, euler, midpoint, fine;
};
PathColours path_colours(const Theme& theme);

/// In every tile, of its own lane: the node, its path and the paths to compare it with, the nodes that are
/// read with their weights, those that bound it, and the particles. Over curves, the same of the selected
/// lane: the samples that are read, as large as they count, where they are read, and the node.
class InspectedOverlay final : public FieldOverlay {
  public:
    InspectedOverlay(const Theme& theme, const RunView& run, const Inspection& inspection)
        : theme_(theme), run_(run), inspection_(inspection) {}

    void draw(const FieldViewports& fields, ImDrawList& list, bool claimed) override;
    std::vector<PlotMark> marks() const override;

  private:
    const Theme& theme_;
    const RunView& run_;
    const Inspection& inspection_;
};

}  // namespace whorl::app
