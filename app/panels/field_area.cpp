#include "app/panels/field_area.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/panels/curve_view.h"
#include "app/panels/widgets.h"
#include "app/plot/ticks.h"
#include "app/render/colour_bar.h"

namespace whorl::app {
namespace {

float header_height(const Theme& theme) {
    return theme.title->FontSize + theme.small->FontSize + theme.px(18);
}

float bar_space(const Theme& theme) {
    return theme.px(16) + theme.px(12 + 6) + theme.small->FontSize + theme.px(6);
}

float aspect(const Grid& grid) {
    return static_cast<float>(grid.ny) / static_cast<float>(grid.nx);
}

/// What to do with the field, from all of it to what fits a narrow window.
const char* hints(const Snapshot& s, float width) {
    constexpr const char* flat[] = {"Space pauses  ·  . steps  ·  R resets  ·  F12 picture  ·  H keys",
                                    "Space pauses  ·  H keys"};
    constexpr const char* plane[] = {
        "Drag to inject smoke  ·  right-drag to push  ·  shift-drag to build  ·  Space pauses  ·  F12 "
        "picture  "
        "·  H keys",
        "Drag to inject smoke  ·  right-drag to push  ·  Space pauses  ·  F12 picture  ·  H keys",
        "Drag to inject smoke  ·  right-drag to push  ·  H keys", "Drag to inject smoke  ·  H keys"};
    const std::span<const char* const> all =
        s.grid.dimensions() == 1 ? std::span<const char* const>(flat) : plane;
    for (const char* line : all) {
        if (ImGui::CalcTextSize(line).x <= width) return line;
    }
    return all.back();
}

/// Position, value and cell under the mouse.
std::string reading(const PanelContext& context, const FieldPlacement& place) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto px = static_cast<double>(mouse.x);
    const auto py = static_cast<double>(mouse.y);
    if (!place.drawn() || place.covered || !place.contains(px, py)) return {};
    const Snapshot& s = context.snapshot();
    const WorldPoint at = place.world(px, py);
    const int i = std::clamp(static_cast<int>(at.x / s.grid.h), 0, s.grid.nx - 1);
    const int j = std::clamp(static_cast<int>(at.y / s.grid.h), 0, s.grid.ny - 1);
    const Field& field = *context.field;
    const bool solid = s.solids[static_cast<std::size_t>(j) * s.grid.nx + i] != 0;
    char line[96];
    std::snprintf(line, sizeof line, "(%.2f, %.2f)  cell %d, %d  ", at.x, at.y, i, j);
    return line + (solid ? "solid" : figure(static_cast<double>(field(i, j)), 4));
}

/// The first of the texts that fits, at the right end of a line.
void at_right(const Theme& theme, float right, float y, float room, const std::string& line) {
    ImGui::PushFont(theme.mono);
    const std::string shown = fitted(line, room);
    ImGui::SetCursorScreenPos({right - ImGui::CalcTextSize(shown.c_str()).x, y});
    text(theme.palette.text, shown);
    ImGui::PopFont();
}

void draw_header(PanelContext& context, const FieldPlacement& place, ImVec2 corner, float width) {
    const Theme& theme = context.theme;
    const View& view = *context.view.shown;
    ImGui::SetCursorScreenPos(corner);
    ImGui::PushFont(theme.title);
    text(theme.palette.text, view.label);
    const float used = ImGui::GetItemRectSize().x;
    ImGui::PopFont();
    const std::string under = reading(context, place);
    if (!under.empty()) {
        at_right(theme, corner.x + width, corner.y + theme.px(3), width - used - theme.px(12), under);
    } else if (!view.unit.empty()) {
        ImGui::SameLine(0, theme.px(8));
        ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, corner.y + theme.px(4)});
        ImGui::PushFont(theme.small);
        text(theme.palette.text_dim, view.unit);
        ImGui::PopFont();
    }
    ImGui::PushFont(theme.small);
    ImGui::SetCursorScreenPos({corner.x, corner.y + theme.title->FontSize + theme.px(6)});
    text(theme.palette.text_dim, fitted(hints(context.snapshot(), width), width));
    ImGui::PopFont();
}

void draw_brush(const PanelContext& context, const FieldPlacement& place, ImDrawList& list) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (place.covered || !place.contains(static_cast<double>(mouse.x), static_cast<double>(mouse.y))) return;
    const double pixels = place.rect.width / place.width;
    const auto radius = static_cast<float>(context.scene().brush.radius * pixels);
    const ImGuiIO& io = ImGui::GetIO();
    const ImU32 colour =
        io.KeyShift || io.KeyCtrl ? context.theme.palette.series[1] : context.theme.palette.accent;
    const float line = context.theme.px(1);
    list.AddCircle(mouse, radius + line, IM_COL32(0, 0, 0, 140), 0, line);
    list.AddCircle(mouse, radius, colour, 0, line);
}

/// A card of one line at the centre of `x`. @return its height
float card(const Theme& theme, ImDrawList& list, float x, float y, float room, const std::string& line,
           ImU32 edge) {
    const ImFont& font = *theme.body;
    const float pad = theme.px(11);
    const float wrap = room - 2 * pad - theme.px(6);
    const ImVec2 size =
        font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap, line.c_str(), line.c_str() + line.size());
    const float width = size.x + 2 * pad;
    const ImVec2 low{std::floor(x - 0.5f * width), std::floor(y)};
    const ImVec2 high{low.x + width, low.y + size.y + 1.4f * pad};
    list.AddRectFilled(low, high, faded(theme.palette.panel, 0.94f), theme.px(5));
    list.AddRect(low, high, edge, theme.px(5), 0, theme.px(1));
    list.AddText(&font, font.FontSize, {low.x + pad, low.y + 0.7f * pad}, theme.palette.text, line.c_str(),
                 line.c_str() + line.size(), wrap);
    return high.y - low.y;
}

void draw_notices(const PanelContext& context, const Notices& notices, const PixelRect& rect) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto middle = static_cast<float>(rect.x) + 0.5f * static_cast<float>(rect.width);
    const auto room = static_cast<float>(rect.width);
    const auto bottom = static_cast<float>(rect.y + rect.height) - context.theme.px(12);
    float height = 0;
    const auto& shown = notices.shown();
    const auto draw = [&](ImDrawList& on, float y) {
        for (const Notice& notice : shown) {
            const ImU32 edge = notice.kind == Notice::Kind::Warning ? context.theme.palette.accent
                                                                    : context.theme.palette.border;
            y += card(context.theme, on, middle, y, room, notice.text, edge) + context.theme.px(6);
        }
        return y;
    };
    // Once aside, to learn the height.
    ImDrawList aside(ImGui::GetDrawListSharedData());
    aside._ResetForNewFrame();
    aside.PushTextureID(ImGui::GetIO().Fonts->TexID);
    aside.PushClipRectFullScreen();
    height = draw(aside, 0);
    draw(list, bottom - height);
}

void draw_failure(PanelContext& context, const PixelRect& rect) {
    const auto& failure = context.snapshot().failure;
    if (!failure) return;
    const Theme& theme = context.theme;
    ImGui::SetCursorScreenPos(
        {static_cast<float>(rect.x) + theme.px(12), static_cast<float>(rect.y) + theme.px(12)});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, IM_COL32(74, 26, 22, 240));
    ImGui::PushStyleColor(ImGuiCol_Border, theme.palette.accent);
    ImGui::BeginChild("failure", {static_cast<float>(rect.width) - theme.px(24), theme.px(104)}, true,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PushFont(theme.bold);
    ImGui::TextUnformatted("The run has stopped");
    ImGui::PopFont();
    ImGui::TextWrapped("At %s. The last good state is shown.", failure->c_str());
    if (ImGui::Button("Reset")) context.remote.restart();
    context.trace.control("failure-reset");
    ImGui::EndChild();
    ImGui::PopStyleColor(2);
}

}  // namespace

float field_width_for(const Theme& theme, const Grid& grid, float height) {
    const float room = height - header_height(theme) - bar_space(theme);
    return grid.dimensions() == 1 ? FLT_MAX : room / aspect(grid);
}

FieldPlacement draw_field_area(PanelContext& context) {
    const Theme& theme = context.theme;
    const Snapshot& s = context.snapshot();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();

    FieldPlacement place;
    place.width = s.grid.width();
    place.height = s.grid.height();
    place.covered = context.view.help ||
                    ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    const bool curve = s.grid.dimensions() == 1;
    const float width =
        curve ? room.x : std::floor(std::min(room.x - 2, field_width_for(theme, s.grid, room.y)));
    const float left = std::floor(corner.x + 0.5f * (room.x - width));
    const float top = std::floor(corner.y + header_height(theme));
    const float height = curve ? room.y - header_height(theme) : std::floor(width * aspect(s.grid));
    PixelRect rect{static_cast<int>(left), static_cast<int>(top), std::max(1, static_cast<int>(width)),
                   std::max(1, static_cast<int>(height))};
    if (!curve) place.rect = rect;

    draw_header(context, place, {left, corner.y}, width);
    context.trace.place("field", left, top, width, height);
    if (curve) {
        ImGui::SetCursorScreenPos({left, top});
        draw_curve_view(context, {width, height});
    } else {
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRect({left - 1, top - 1}, {left + width + 1, top + height + 1}, theme.palette.border);
        const Range range = context.view.range.ends();
        const ColourBar bar{context.view.map(), range.lo, range.hi};
        draw_colour_bar(list, theme, bar, {left, top + height + theme.px(14)}, width);
        list.PushClipRect({left, top}, {left + width, top + height}, true);
        draw_brush(context, place, list);
        list.PopClipRect();
    }
    draw_failure(context, rect);
    draw_notices(context, context.remote.notices(), rect);
    return place;
}

}  // namespace whorl::app
