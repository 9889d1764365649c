// What the labs have in common: rows of chips, and the interpolations' colours.
#pragma once

#include <span>
#include <string_view>

#include "app/labs/lab_state.h"
#include "app/panels/panel.h"

namespace whorl::app {

/// A colour for each interpolation of the registry, by its place there.
ImU32 interpolation_colour(const Theme& theme, std::size_t k);

/// One of a row of chips that share `width`; all but the first stand beside the one before.
/// @return whether it was clicked
bool lab_chip(PanelContext& context, const std::string& key, const TooltipText& help, bool chosen,
              float width, bool first);

/// A square that is filled where what it stands for is shown.
void swatch(const Theme& theme, ImVec2 middle, ImU32 colour, bool filled);

/// A swatch with a scheme's name, which shows the scheme or leaves it out. @return whether it was clicked
bool legend_toggle(PanelContext& context, const std::string& key, const SchemeInfo& info, ImU32 colour,
                   bool shown, float width);

/// The width of each of `count` chips that fill the line.
float chip_width(int count);

}  // namespace whorl::app
