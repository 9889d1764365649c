// The slice's line over the fields: where it is on screen, what the pointer is near, and its picture.
#pragma once

#include <imgui.h>

#include <optional>

#include "app/labs/lab_state.h"
#include "app/panels/panel.h"
#include "app/ui/field_viewports.h"

namespace whorl::app {

/// What lies under a pixel.
struct SliceHit {
    SliceGrip grip;
    std::size_t lane;  ///< on whose tile
    double part;       ///< of the line, 0 to 1
};

/// The end or the place of the line that a pixel is near enough to, if any; ends come first.
/// @param point pixels to a point
std::optional<SliceHit> hit_slice(const SliceLine& line, const SessionSnapshot& session,
                                  const FieldViewports& place, glm::dvec2 pixel, float point);

/// Draws the line with its ends over each field while its window is open, and sees what the pointer is near.
void draw_slice_line(const PanelContext& context, const FieldViewports& place, ImDrawList& list);

}  // namespace whorl::app
