// The slice's line, and what of it the pointer is on or drags.
#pragma once

#include <optional>

#include "app/labs/slice_line.h"

namespace whorl::app {

/// Shared by the slice's window, its tool, and what is drawn over the fields.
struct Slice {
    bool open = false;
    SliceLine line;
    bool compares_interpolations = false;       ///< of the selected lane, instead of the lanes
    SliceGrip held = SliceGrip::None;           ///< what the pointer drags
    SliceGrip under_pointer = SliceGrip::None;  ///< what it would drag
    std::optional<double> pointed_on_field;     ///< the part of the line under the pointer, 0 to 1 ...
    std::optional<double> pointed_in_plot;      ///< ... and under the plot's hairline

    SliceGrip grip() const { return held != SliceGrip::None ? held : under_pointer; }
};

}  // namespace whorl::app
