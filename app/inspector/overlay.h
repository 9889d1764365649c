// What the inspector draws over a field: where a node's value comes from.
#pragma once

#include <imgui.h>

#include <vector>

#include "app/panels/panel.h"
#include "app/plot/plot.h"
#include "app/ui/field_viewports.h"

namespace whorl::app {

/// Colours of the paths along the flow, over any colour map.
struct PathColours {
    ImU32 scheme, euler, midpoint, fine;
};
PathColours path_colours(const Theme& theme);

/// In every tile, of its own lane: the node, its path and the paths to compare it with, the nodes that are
/// read with their weights, those that bound it, and the particles.
void draw_inspected(const PanelContext& context, const FieldViewports& place, ImDrawList& list);

/// The same of the selected lane, where fields are drawn as curves: the samples that are read, as large as
/// they count, where they are read, and the node.
std::vector<PlotMark> inspected_marks(const PanelContext& context);

}  // namespace whorl::app
