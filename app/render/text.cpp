// See text.h.
#include "app/render/text.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace whorl::app {
namespace {

/// Distance between the lines of a paragraph, as a part of the font's size.
constexpr float line_height = 1.4f;

/// Calls `line(begin, end)` for every line of the text, wrapped at `width` pixels.
template <class Line>
void for_each_line(const ImFont& font, const std::string& text, float width, Line&& line) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        const char* const paragraph_end = std::find(at, end, '\n');
        do {
            const char* stop = font.CalcWordWrapPositionA(1.0f, at, paragraph_end, width);
            if (stop == at && stop < paragraph_end) ++stop;  // not even a letter fits
            line(at, stop);
            at = stop;
            while (at < paragraph_end && *at == ' ') ++at;
        } while (at < paragraph_end);
        if (at < end) ++at;
    }
}

/// Whether a byte is inside a UTF-8 letter, not at its start.
bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

}  // namespace

float text_width(const ImFont& font, std::string_view text) {
    if (text.empty()) return 0.0f;  // a null end means "up to the terminator" to ImGui
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0f, text.data(), text.data() + text.size()).x;
}

void add_text(ImDrawList& list, const ImFont& font, ImVec2 at, ImU32 colour, std::string_view text) {
    if (text.empty()) return;
    list.AddText(&font, font.FontSize, {std::floor(at.x), std::floor(at.y)}, colour, text.data(),
                 text.data() + text.size());
}

std::string fitted(const ImFont& font, std::string_view text, float width) {
    if (text_width(font, text) <= width) return std::string(text);
    const std::string_view ellipsis = "…";
    const float room = width - text_width(font, ellipsis);
    while (!text.empty() && text_width(font, text) > room) {
        while (text.size() > 1 && continues(text.back())) text.remove_suffix(1);
        text.remove_suffix(1);
    }
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return std::string(text) + std::string(ellipsis);
}

float paragraph_height(const ImFont& font, const std::string& text, float width) {
    float lines = 0.0f;
    for_each_line(font, text, width, [&](const char*, const char*) { lines += 1.0f; });
    return lines > 0.0f ? font.FontSize + (lines - 1.0f) * std::round(line_height * font.FontSize) : 0.0f;
}

void add_paragraph(ImDrawList& list, const ImFont& font, ImVec2 at, float width, ImU32 colour,
                   const std::string& text) {
    for_each_line(font, text, width, [&](const char* begin, const char* end) {
        list.AddText(&font, font.FontSize, at, colour, begin, end);
        at.y += std::round(line_height * font.FontSize);
    });
}

}  // namespace whorl::app
