// The field of a snapshot in the window, behind the panels.
#pragma once

#include "app/panels/field_area.h"
#include "app/panels/slabs.h"
#include "app/render/arrows.h"
#include "app/render/field_view.h"
#include "app/render/solids.h"

namespace whorl::app {

/// Needs a current OpenGL context from construction to destruction.
class FieldPainter {
  public:
    /// Clears the framebuffer to the background and the slabs.
    static void clear(const Theme& theme, const Slabs& slabs, int framebuffer_height);
    /// Draws the field where it belongs.
    /// @param field  what the chosen view shows of the snapshot
    void draw(const Snapshot& snapshot, std::uint64_t serial, const Field& field, const ViewState& view,
              const FieldPlacement& place, const Theme& theme, int framebuffer_height);

  private:
    FieldView field_view_;
    FieldTexture texture_;
    Solids solids_;
    Arrows arrows_;
    std::uint64_t serial_ = ~std::uint64_t{0};  ///< of the snapshot that has been uploaded
    const View* view_ = nullptr;                ///< and of which view
};

}  // namespace whorl::app
