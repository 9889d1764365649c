// The stack widget: what several causes added and took, over time.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "app/plot/plot.h"

namespace whorl::app {

/// Draws a card with the signed contributions `parts` stacked, positive ones above 0 and negative ones below,
/// in their order away from 0, and their sum as a line. Where samples are denser than pixels, each column
/// shows their mean. All parts have the same x; both axes are linear: `log_x` and `log_y` are not read.
/// @param net  name of the sum
/// @return x of the sample under the pointer, if any
std::optional<double> draw_stack(const Theme& theme, const Plot& plot, std::span<const Series> parts,
                                 std::string_view net);

}  // namespace whorl::app
