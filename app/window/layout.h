// Three columns: controls, field, measures.
#pragma once

#include "app/render/theme.h"
#include "core/grid/grid.h"

namespace whorl::app {

/// A column's left edge and width, pixels.
struct Column {
    float x, width;
};

/// All columns share top and height.
struct Layout {
    float top, height;
    Column controls, field, measures;
};

/// The field gets the most; what it cannot use, because its domain has another shape, widens the plots.
Layout lay_out(const Theme& theme, const Grid& grid, float width, float height);

}  // namespace whorl::app
