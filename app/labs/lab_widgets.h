// What the labs have in common: the interpolations' colours, and a legend that is clicked.
#pragma once

#include <string>

#include "app/ui/ui.h"
#include "core/base/scheme_info.h"

namespace whorl::app {

/// A colour for each interpolation of the registry, by its place there.
ImU32 interpolation_colour(const Theme& theme, std::size_t k);

/// A square that is filled where what it stands for is shown.
void swatch(const Theme& theme, ImVec2 middle, ImU32 colour, bool filled);

/// A swatch with a scheme's name, which shows the scheme or leaves it out. @return whether it was clicked
bool legend_toggle(Ui& ui, const std::string& key, const SchemeInfo& info, ImU32 colour, bool shown,
                   float width);

}  // namespace whorl::app
