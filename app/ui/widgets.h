// Small pieces that all panels are laid out with.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/render/theme.h"

namespace whorl::app {

/// Width of the labels' column, pixels.
float label_width();

/// A label at the left; the next item takes the rest of the line.
void row_label(const Theme& theme, std::string_view text);

/// Whether the pointer rests on the label of the row that the last item begins. Asked once for each row.
bool on_row_label();

/// The text, or as much of it as fits `width` pixels in the current font, with an ellipsis.
std::string fitted(std::string_view text, float width);

/// A foldable heading. @return whether what is below it is to be drawn
bool heading(const Theme& theme, const char* title, bool open_at_first);

/// Widths of labels' controls in a line: what is free of `room` goes to all of them alike.
/// @param gap  between two of them
std::vector<float> shared_widths(std::span<const char* const> labels, float room, float gap);

/// The width of each of `count` chips that fill the line, half a spacing apart.
float chip_width(int count);

/// A button that shows whether it is chosen.
bool chip(const Theme& theme, const char* label, bool chosen, float width);

/// A line of an open list; the arrow keys begin at the chosen one. @return whether it was taken
bool list_item(const char* label, bool chosen);

/// A check box that looks like the theme. @return whether it was clicked
bool check(const char* label, bool value);

/// The ends of a slider, and whether it goes by ratios.
struct SliderRange {
    double min, max;
    bool logarithmic = false;
};
/// Sliders that write their value beside the grab, not under it, with the unit where there is room.
/// @param format  of the number alone, as printf takes it
/// @return whether the value was changed; typed ones may lie beyond the ends
bool slider(const Theme& theme, const char* id, double& value, SliderRange range, std::string_view unit,
            const char* format);
bool slider(const Theme& theme, const char* id, int& value, SliderRange range, std::string_view unit);

/// Text in a colour of the palette.
void text(ImU32 colour, std::string_view line);

}  // namespace whorl::app
