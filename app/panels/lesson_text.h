// Lays out the blocks of a lesson's text.
#pragma once

#include <span>

#include "app/lessons/markup.h"
#include "app/panels/slabs.h"
#include "app/render/theme.h"

namespace whorl::app {

/// Draws blocks below each other at the cursor, wrapped to the width that is left in the current window.
void draw_blocks(const Theme& theme, Slabs& slabs, std::span<const Block> blocks);

/// Draws texts as items of a list.
void draw_items(const Theme& theme, std::span<const std::string> items);

}  // namespace whorl::app
