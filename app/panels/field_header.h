// The lines above the fields: what is shown, the value under the pointer, and how lanes are compared.
#pragma once

#include "app/panels/panel.h"
#include "app/ui/field_viewports.h"

namespace whorl::app {

/// What the colours or curves stand for: the view, and what is taken from it.
std::string shown_quantity(const PanelContext& context);

/// With the air below it, pixels.
float field_header_height(const Theme& theme, bool several);

/// Draws at `corner`, `width` pixels wide.
void draw_field_header(PanelContext& context, const FieldViewports& place, ImVec2 corner, float width);

}  // namespace whorl::app
