// Lines and paragraphs of text on an ImGui draw list.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace whorl::app {

/// Width of one line, pixels.
float text_width(const ImFont& font, std::string_view text);

/// Draws one line, on whole pixels.
void add_text(ImDrawList& list, const ImFont& font, ImVec2 at, ImU32 colour, std::string_view text);

/// The line, or as much of it as fits with an ellipsis behind.
std::string fitted(const ImFont& font, std::string_view text, float width);

/// Height of a text wrapped at `width`, pixels; 0 if it is empty.
float paragraph_height(const ImFont& font, const std::string& text, float width);

/// Draws a text wrapped at `width`.
void add_paragraph(ImDrawList& list, const ImFont& font, ImVec2 at, float width, ImU32 colour,
                   const std::string& text);

}  // namespace whorl::app
