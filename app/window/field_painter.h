// The fields of a snapshot in the window, behind the panels.
#pragma once

#include <deque>
#include <vector>

#include "app/render/arrows.h"
#include "app/render/field_view.h"
#include "app/render/solids.h"
#include "app/render/theme.h"
#include "app/run/view_settings.h"
#include "app/ui/background_rects.h"
#include "app/ui/field_viewports.h"
#include "app/views/lane_fields.h"

namespace whorl::app {

/// Needs a current OpenGL context from construction to destruction.
class FieldPainter {
  public:
    /// Clears the framebuffer to the background and the backgrounds.
    static void clear(const Theme& theme, const BackgroundRects& backgrounds, int framebuffer_height);
    /// Draws the fields where they belong. A field is uploaded once, when it is first drawn.
    void draw(const SessionSnapshot& session, const LaneFields& fields, const ViewSettings& view,
              const FieldViewports& place, const Theme& theme, int framebuffer_height);

  private:
    /// What is drawn of a lane.
    struct Part {
        FieldTexture texture;
        Solids solids;
        std::vector<std::uint8_t> mask;  ///< of the solids
        long version = 0;                ///< of the fields, when the texture was uploaded
    };

    void upload(const Snapshot& snapshot, const LaneFields& fields, std::size_t lane, Part& part);

    FieldView field_view_;
    Arrows arrows_;
    std::deque<Part> parts_;  ///< of the lanes, as far as they have been drawn
};

}  // namespace whorl::app
