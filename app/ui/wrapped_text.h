// Lays out the blocks of a lesson's text.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/lessons/markup.h"
#include "app/render/theme.h"
#include "app/ui/background_rects.h"

namespace whorl::app {

/// A text in lines of at most `width` pixels in the current font. Lines end at spaces only, so that "3.11"
/// stays whole, and not beside a sign such as "=" or before "%", so that "ζ = 2" does too; a longer word has
/// a line of its own.
std::string broken(std::string_view text, float width);

/// Draws a text, broken to the width that is left less `margin`.
void draw_wrapped(ImU32 colour, std::string_view line, float margin = 0);

/// Draws blocks below each other at the cursor, wrapped to the width that is left in the current window.
void draw_blocks(const Theme& theme, BackgroundRects& backgrounds, std::span<const Block> blocks);

/// Draws texts as items of a list.
void draw_items(const Theme& theme, std::span<const std::string> items);

}  // namespace whorl::app
