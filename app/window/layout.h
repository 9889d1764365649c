// Three columns: controls, field, measures.
#pragma once

#include "app/panels/field_layout.h"
#include "app/render/theme.h"

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

/// The fields get the most; what they cannot use, because their domain has another shape, widens the plots.
/// @param reading  whether lessons or the inspector stand where the measures do: text needs more room
Layout lay_out(const Theme& theme, const FieldShape& shape, float width, float height, bool reading);

/// The column that the inspector stands over: lessons leave it that of the controls.
inline const Column& inspector_column(const Layout& layout, bool lessons) {
    return lessons ? layout.controls : layout.measures;
}

}  // namespace whorl::app
