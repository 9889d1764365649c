// From the pointer to the slice's line on the field.
#pragma once

#include "app/labs/slice_state.h"
#include "app/render/theme.h"
#include "app/run/run_view.h"
#include "app/run/tool.h"

namespace whorl::app {

/// Drags an end of the line, or all of it, while the slice's window is open.
class SliceTool final : public Tool {
  public:
    SliceTool(const Theme& theme, const RunView& run, Slice& slice)
        : theme_(theme), run_(run), slice_(slice) {}

    bool take(const InputEvent& event, const FieldViewports& fields) override;
    bool hover(const FieldViewports& fields) override;

  private:
    const Theme& theme_;
    const RunView& run_;
    Slice& slice_;
    std::size_t lane_ = 0;  ///< on whose tile the drag began
    glm::dvec2 began_{};    ///< there, in fractions of the domain
    SliceLine before_;      ///< the line at that time
};

}  // namespace whorl::app
