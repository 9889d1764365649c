#include "app/tutorial/tour_card.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/wrapped_text.h"

namespace whorl::app {
namespace {

constexpr float card_width = 316;       // points
constexpr float card_padding = 16;      // points
constexpr float ring_distance = 4;      // points from the target
constexpr float between_the_parts = 8;  // points

/// A ring that is seen at once on anything. Darkening the rest would take a software rasteriser as long as
/// all else of a frame.
void draw_ring(ImDrawList& list, const Theme& theme, const ScreenBox& box) {
    const float rounding = theme.px(6);
    list.AddRect(box.low, box.high, faded(theme.palette.accent, 0.3f), rounding, 0, theme.px(7));
    list.AddRect(box.low, box.high, theme.palette.accent, rounding, 0, theme.px(2));
}

ScreenBox widened(const ScreenBox& box, float by, ImVec2 screen) {
    return {{std::max(0.0f, box.low.x - by), std::max(0.0f, box.low.y - by)},
            {std::min(screen.x, box.high.x + by), std::min(screen.y, box.high.y + by)}};
}

float height_of(const ImFont& font, const std::string& text) {
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, text.c_str()).y;
}

/// Begins the card's window, with the ring around what it speaks of.
void begin_card(const Theme& theme, ImVec2 corner, ImVec2 size, const std::optional<ScreenBox>& ring) {
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(theme.px(card_padding), theme.px(card_padding)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(8), theme.px(between_the_parts)));
    ImGui::Begin("tour", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground);
    // A list that a control has opened stays above.
    if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    if (ring) draw_ring(list, theme, *ring);
    const ImVec2 end{corner.x + size.x, corner.y + size.y};
    list.AddRectFilled(corner, end, theme.palette.panel, theme.px(8));
    list.AddRect(corner, end, theme.palette.accent, theme.px(8), 0, theme.thin());
    list.PopClipRect();
}

}  // namespace

ImVec2 card_corner(const ScreenBox& target, ImVec2 card, ImVec2 screen, float gap) {
    const ImVec2 most{screen.x - gap - card.x, screen.y - gap - card.y};
    const auto within = [&](float x, float y) {
        return ImVec2{std::floor(std::max(gap, std::min(x, most.x))),
                      std::floor(std::max(gap, std::min(y, most.y)))};
    };
    const float right = target.high.x + gap;
    const float left = target.low.x - gap - card.x;
    const float below = target.high.y + gap;
    const float above = target.low.y - gap - card.y;
    if (right <= most.x) return within(right, target.low.y);
    if (left >= gap) return within(left, target.low.y);
    const float centre = 0.5f * (target.low.x + target.high.x - card.x);
    if (below <= most.y) return within(centre, below);
    if (above >= gap) return within(centre, above);
    return within(centre, target.high.y - gap - card.y);
}

std::optional<ScreenBox> target_of(const TourStop& stop, const ControlRects& places) {
    std::optional<ScreenBox> all;
    for (const char* key : stop.targets) {
        const auto place = places.in_sight(key);
        if (!place) continue;
        const ScreenBox box{{place->x, place->y}, {place->x + place->width, place->y + place->height}};
        if (!all) all = box;
        all->low = {std::min(all->low.x, box.low.x), std::min(all->low.y, box.low.y)};
        all->high = {std::max(all->high.x, box.high.x), std::max(all->high.y, box.high.y)};
    }
    return all;
}

void TourCard::draw() {
    const Theme& theme = ui_.theme;
    const TourStop& stop = tour_.stop();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float padding = theme.px(card_padding);
    const float between = theme.px(between_the_parts);
    const float width = std::min(theme.px(card_width), screen.x - 2 * padding);
    ImGui::PushFont(theme.body);
    const std::string text_lines = broken(stop.text, width - 2 * padding);
    ImGui::PopFont();
    const float height = 2 * padding + theme.small->FontSize + theme.title->FontSize +
                         height_of(*theme.body, text_lines) + ImGui::GetFrameHeight() + 3 * between;

    const auto found = target_of(stop, ui_.log.rects());
    const ScreenBox middle{{0.5f * screen.x, 0.5f * screen.y}, {0.5f * screen.x, 0.5f * screen.y}};
    const ScreenBox target = widened(found.value_or(middle), theme.px(ring_distance), screen);
    const ImVec2 corner = card_corner(target, {width, height}, screen, theme.px(12));

    begin_card(theme, corner, {width, height}, found ? std::optional(target) : std::nullopt);
    ImGui::PushFont(theme.small);
    text(theme.palette.text_dim,
         std::to_string(tour_.place() + 1) + " of " + std::to_string(tour_stops().size()));
    ImGui::PopFont();
    ImGui::PushFont(theme.title);
    text(theme.palette.text, stop.title);
    ImGui::PopFont();
    text(theme.palette.text, text_lines);
    draw_buttons();
    ui_.log.rect("tour-card=" + std::to_string(tour_.place() + 1), corner.x, corner.y, width, height);
    const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::End();
    ImGui::PopStyleVar(2);
    tour_.drawn(hovered);
}

void TourCard::draw_buttons() {
    const Theme& theme = ui_.theme;
    const float width = theme.px(78);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const bool last = tour_.last();
    if (!last &&
        ui_.button("Skip", "tour-skip", width, {"", "Ends the tour. H brings it back. Key: Esc", "", "", ""}))
        return tour_.skip();
    if (!last) ImGui::SameLine();
    ImGui::SetCursorPosX(right - 2 * width - gap);
    const bool back =
        ui_.button("Back", "tour-back", width, {"", "The card before. Key: ←", "", "", ""}, !tour_.first());
    ImGui::SameLine();
    const char* const help = last ? "Ends the tour. Keys: Enter, →" : "The next card. Keys: Enter, →";
    const bool next = ui_.accent_button(last ? "Done" : "Next", "tour-next", width, {"", help, "", "", ""});
    if (back) tour_.back();
    if (next) tour_.next();
}

}  // namespace whorl::app
