// A one-dimensional run: a curve for every lane, over the exact one.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Draws at ImGui's cursor.
void draw_curve_view(PanelContext& context, ImVec2 size);

}  // namespace whorl::app
