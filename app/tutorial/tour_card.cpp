#include "app/tutorial/tour_card.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/widgets.h"
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

bool button(PanelContext& context, const char* label, const char* key, float width, const char* help) {
    const bool pressed = ImGui::Button(label, {width, 0});
    context.log.control(key);
    context.tooltip.item(context.theme, key, {"", help, "", "", ""});
    return pressed;
}

/// Skip at the left, the way back and on at the right.
void draw_buttons(PanelContext& context, Tour& tour) {
    const Theme& theme = context.theme;
    const Palette& palette = theme.palette;
    const float width = theme.px(78);
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    const bool last = tour.last();
    if (!last && button(context, "Skip", "tour-skip", width, "Ends the tour. H brings it back. Key: Esc"))
        return tour.skip();
    if (!last) ImGui::SameLine();
    ImGui::SetCursorPosX(right - 2 * width - gap);
    ImGui::BeginDisabled(tour.first());
    const bool back = button(context, "Back", "tour-back", width, "The card before. Key: ←");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button, palette.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(palette.accent, 0.9f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(palette.accent, 0.8f));
    ImGui::PushStyleColor(ImGuiCol_Text, palette.accent_text);
    const bool next = button(context, last ? "Done" : "Next", "tour-next", width,
                             last ? "Ends the tour. Keys: Enter, →" : "The next card. Keys: Enter, →");
    ImGui::PopStyleColor(4);
    if (back) tour.back();
    if (next) tour.next();
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

void draw_tour(PanelContext& context) {
    Tour& tour = context.view.tour;
    if (!context.view.tour_in_sight(context.files)) return;
    const Theme& theme = context.theme;
    const TourStop& stop = tour.stop();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float padding = theme.px(card_padding);
    const float between = theme.px(between_the_parts);
    const float width = std::min(theme.px(card_width), screen.x - 2 * padding);
    ImGui::PushFont(theme.body);
    const std::string text_lines = broken(stop.text, width - 2 * padding);
    ImGui::PopFont();
    const float height = 2 * padding + theme.small->FontSize + theme.title->FontSize +
                         height_of(*theme.body, text_lines) + ImGui::GetFrameHeight() + 3 * between;

    const auto found = target_of(stop, context.log.rects());
    const ScreenBox middle{{0.5f * screen.x, 0.5f * screen.y}, {0.5f * screen.x, 0.5f * screen.y}};
    const ScreenBox target = widened(found.value_or(middle), theme.px(ring_distance), screen);
    const ImVec2 corner = card_corner(target, {width, height}, screen, theme.px(12));

    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(padding, padding));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(theme.px(8), between));
    ImGui::Begin("tour", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground);
    // A list that a control has opened stays above.
    if (!ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    if (found) draw_ring(list, theme, target);
    const ImVec2 end{corner.x + width, corner.y + height};
    list.AddRectFilled(corner, end, theme.palette.panel, theme.px(8));
    list.AddRect(corner, end, theme.palette.accent, theme.px(8), 0, theme.thin());
    list.PopClipRect();

    ImGui::PushFont(theme.small);
    text(theme.palette.text_dim,
         std::to_string(tour.place() + 1) + " of " + std::to_string(tour_stops().size()));
    ImGui::PopFont();
    ImGui::PushFont(theme.title);
    text(theme.palette.text, stop.title);
    ImGui::PopFont();
    text(theme.palette.text, text_lines);
    draw_buttons(context, tour);
    context.log.rect("tour-card=" + std::to_string(tour.place() + 1), corner.x, corner.y, width, height);
    const bool hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::End();
    ImGui::PopStyleVar(2);
    tour.drawn(hovered);
}

}  // namespace whorl::app
