#include "app/panels/field_messages.h"

#include <imgui.h>

#include <cfloat>
#include <cmath>

namespace whorl::app {
namespace {

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

}  // namespace

void draw_notifications(const Theme& theme, const Notifications& notifications, const PixelRect& rect) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto middle = static_cast<float>(rect.x) + 0.5f * static_cast<float>(rect.width);
    const auto room = static_cast<float>(rect.width);
    const auto bottom = static_cast<float>(rect.y + rect.height) - theme.px(12);
    const auto& shown = notifications.shown();
    const auto draw = [&](ImDrawList& on, float y) {
        for (const Notification& notification : shown) {
            const ImU32 edge = notification.kind == Notification::Kind::Warning ? theme.palette.accent
                                                                                : theme.palette.border;
            y += card(theme, on, middle, y, room, notification.text, edge) + theme.px(6);
        }
        return y;
    };
    // Once aside, to learn the height.
    ImDrawList aside(ImGui::GetDrawListSharedData());
    aside._ResetForNewFrame();
    aside.PushTextureID(ImGui::GetIO().Fonts->TexID);
    aside.PushClipRectFullScreen();
    const float height = draw(aside, 0);
    draw(list, bottom - height);
}

void draw_failure(Ui& ui, RunControl& run, const PixelRect& rect) {
    const auto& failure = run.snapshot().failure;
    if (!failure) return;
    const Theme& theme = ui.theme;
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
    if (ui.button(
            "Reset", "failure-reset", 0,
            {"", "Back to the start of the scene, with the schemes as they are set.", "Key: R", "", ""}))
        run.restart();
    ImGui::EndChild();
    ImGui::PopStyleColor(2);
}

}  // namespace whorl::app
