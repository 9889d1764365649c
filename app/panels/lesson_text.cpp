#include "app/panels/lesson_text.h"

#include <imgui.h>

#include "app/panels/widgets.h"

namespace whorl::app {
namespace {

void wrapped(ImU32 colour, std::string_view line) {
    ImGui::PushTextWrapPos(0);
    text(colour, line);
    ImGui::PopTextWrapPos();
}

void draw_heading(const Theme& theme, const Block& block) {
    ImGui::Dummy({0, theme.px(2)});
    ImGui::PushFont(theme.bold);
    wrapped(theme.palette.text, block.text);
    ImGui::PopFont();
}

void draw_item(const Theme& theme, std::string_view line) {
    const float indent = theme.px(14);
    const float left = ImGui::GetCursorPosX();
    text(theme.palette.accent, "•");
    ImGui::SameLine(left + indent);
    wrapped(theme.palette.text, line);
}

/// On a card, with its lines as they are; a line that does not fit is wrapped all the same.
void draw_formula(const Theme& theme, Slabs& slabs, const Block& block) {
    const ImVec2 padding{theme.px(8), theme.px(7)};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(theme.mono);
    const char* const end = block.text.data() + block.text.size();
    const float room = width - 2 * padding.x;
    const float height = ImGui::CalcTextSize(block.text.data(), end, false, room).y + 2 * padding.y;
    slabs.add(*ImGui::GetWindowDrawList(), corner, {corner.x + width, corner.y + height}, theme.px(4),
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

void draw_blocks(const Theme& theme, Slabs& slabs, std::span<const Block> blocks) {
    for (const Block& block : blocks) {
        switch (block.kind) {
            case Block::Kind::Paragraph:
                wrapped(theme.palette.text, block.text);
                break;
            case Block::Kind::Heading:
                draw_heading(theme, block);
                break;
            case Block::Kind::Item:
                draw_item(theme, block.text);
                break;
            case Block::Kind::Formula:
                draw_formula(theme, slabs, block);
                break;
        }
    }
}

void draw_items(const Theme& theme, std::span<const std::string> items) {
    for (const std::string& item : items) draw_item(theme, item);
}

}  // namespace whorl::app
