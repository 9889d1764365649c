// A sum written out: a line a product, and below it the sums that its values come from.
#pragma once

#include <optional>

#include "app/inspector/inspection.h"
#include "app/render/theme.h"
#include "core/inspect/explanation.h"

namespace whorl::app {

/// Draws a sum at the cursor, as wide as the window has room.
/// @param inspection  gets the product under the pointer, of the sums behind the base steps
void draw_sums(const Theme& theme, const Explanation& explanation, Inspection& inspection);

/// A number with `digits` significant digits; a zero has no sign.
std::string written(double value, int digits);

}  // namespace whorl::app
