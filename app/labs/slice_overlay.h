// The slice's line over the fields: where it is on screen, what of it is near a pixel, and its picture.
#pragma once

#include <imgui.h>

#include <optional>

#include "app/labs/slice_state.h"
#include "app/run/field_overlay.h"
#include "app/run/run_view.h"
#include "app/ui/ui.h"

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

/// The line with its ends over each field, while its window is open.
class SliceOverlay final : public FieldOverlay {
  public:
    SliceOverlay(Ui& ui, const RunView& run, Slice& slice) : ui_(ui), run_(run), slice_(slice) {}

    void draw(const FieldViewports& fields, ImDrawList& list, bool claimed) override;

  private:
    Ui& ui_;
    const RunView& run_;
    Slice& slice_;
};

}  // namespace whorl::app
