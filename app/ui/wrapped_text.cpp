#include "app/ui/wrapped_text.h"

#include <imgui.h>

#include <algorithm>

#include "app/ui/widgets.h"

namespace whorl::app {
namespace {

float width_of(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

bool is_sign(std::string_view word) {
    static constexpr std::string_view signs[] = {"=", "+", "−", "·", "×", "/", "≤", "<", ">", "±"};
    return std::find(std::begin(signs), std::end(signs), word) != std::end(signs);
}

/// The words up to where a line may end, which are taken off the text with the space that follows.
std::string_view take_words(std::string_view& text) {
    std::size_t end = 0;
    for (std::size_t begin = 0;;) {
        end = std::min(text.find(' ', begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        if (end == text.size()) break;
        const std::string_view next = text.substr(end + 1, text.find(' ', end + 1) - end - 1);
        if (!is_sign(word) && !is_sign(next) && !next.starts_with('%')) break;
        begin = end + 1;
    }
    const std::string_view words = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return words;
}

void draw_heading(const Theme& theme, const Block& block) {
    ImGui::Dummy({0, theme.px(2)});
    ImGui::PushFont(theme.bold);
    draw_wrapped(theme.palette.text, block.text);
    ImGui::PopFont();
}

void draw_item(const Theme& theme, std::string_view line) {
    const float indent = theme.px(14);
    const float left = ImGui::GetCursorPosX();
    text(theme.palette.accent, "•");
    ImGui::SameLine(left + indent);
    draw_wrapped(theme.palette.text, line);
}

/// On a card, with its lines as they are; a line that does not fit is wrapped all the same.
void draw_formula(const Theme& theme, BackgroundRects& backgrounds, const Block& block) {
    const ImVec2 padding{theme.px(8), theme.px(7)};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(theme.mono);
    const char* const end = block.text.data() + block.text.size();
    const float room = width - 2 * padding.x;
    const float height = ImGui::CalcTextSize(block.text.data(), end, false, room).y + 2 * padding.y;
    backgrounds.add(*ImGui::GetWindowDrawList(), corner, {corner.x + width, corner.y + height}, theme.px(4),
                    theme.palette.card);
    ImGui::SetCursorScreenPos({corner.x + padding.x, corner.y + padding.y});
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + room);
    text(theme.palette.text, block.text);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({width, height});
}

}  // namespace

std::string broken(std::string_view text, float width) {
    std::string lines, line;
    while (!text.empty()) {
        const std::string_view words = take_words(text);
        std::string longer = line.empty() ? std::string(words) : line + ' ' + std::string(words);
        if (line.empty() || width_of(longer) <= width) {
            line = std::move(longer);
            continue;
        }
        lines += line + '\n';
        line = words;
    }
    return lines + line;
}

void draw_wrapped(ImU32 colour, std::string_view line, float margin) {
    text(colour, broken(line, ImGui::GetContentRegionAvail().x - margin));
}

void draw_blocks(const Theme& theme, BackgroundRects& backgrounds, std::span<const Block> blocks) {
    for (const Block& block : blocks) {
        switch (block.kind) {
            case Block::Kind::Paragraph:
                draw_wrapped(theme.palette.text, block.text);
                break;
            case Block::Kind::Heading:
                draw_heading(theme, block);
                break;
            case Block::Kind::Item:
                draw_item(theme, block.text);
                break;
            case Block::Kind::Formula:
                draw_formula(theme, backgrounds, block);
                break;
        }
    }
}

void draw_items(const Theme& theme, std::span<const std::string> items) {
    for (const std::string& item : items) draw_item(theme, item);
}

}  // namespace whorl::app
