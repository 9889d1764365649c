#include "app/panels/lane_list.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/render/text.h"

namespace whorl::app {

void LaneList::rename(int id, const std::string& name) {
    name_ = {.id = id};
    std::copy_n(name.begin(), std::min(name.size(), sizeof name_.text - 1), name_.text);
}

void LaneList::name_field(std::size_t lane) {
    if (!name_.begun) ImGui::SetKeyboardFocusHere();
    name_.begun = true;
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool done =
        ImGui::InputText("##name", name_.text, sizeof name_.text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ui_.explain("lane-name",
                {"Name", "Enter takes it. Without a name, a lane is called by what differs.", "", "", ""});
    if (!done && !ImGui::IsItemDeactivated()) return;
    if (done || ImGui::IsItemDeactivatedAfterEdit()) {
        Arrange changed = run_.arrangement();
        changed.lanes[lane].name = name_.text;
        if (changed.lanes != run_.setup().lanes) run_.arrange(std::move(changed));
    }
    name_ = {};
}

void LaneList::row(std::size_t lane, const std::string& name, const std::string& differs) {
    const std::string key = "lane=" + std::to_string(lane + 1);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton(key.c_str(), {width, height})) run_.select_id(run_.ids()[lane]);
    const ImVec2 end{corner.x + width, corner.y + height};
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && ImGui::IsMouseDoubleClicked(0)) rename(run_.ids()[lane], name);
    const bool reference = static_cast<int>(lane) == run_.setup().reference;
    ui_.explain(key, {name, said_of(differs), "Click to select, double-click to rename", "",
                      reference ? "The reference lane: the others are measured against it." : ""});
    if (lane == run_.selected_in_setup() || hovered)
        ImGui::GetWindowDrawList()->AddRectFilled(
            corner, end,
            ImGui::GetColorU32(lane == run_.selected_in_setup() ? ImGuiCol_Button : ImGuiCol_FrameBg),
            ui_.theme.px(4));
    draw_row(lane, name, differs, corner, end);
}

void LaneList::draw_row(std::size_t lane, const std::string& name, const std::string& differs, ImVec2 corner,
                        ImVec2 end) const {
    const Theme& theme = ui_.theme;
    const bool selected = lane == run_.selected_in_setup();
    const bool reference = static_cast<int>(lane) == run_.setup().reference;
    const float height = end.y - corner.y;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float swatch = theme.px(10);
    const float middle = std::floor(corner.y + 0.5f * (height - swatch));
    float x = corner.x + theme.px(8);
    list.AddRectFilled({x, middle}, {x + swatch, middle + swatch}, theme.lane(static_cast<int>(lane)),
                       theme.px(2));
    x += swatch + theme.px(8);
    float right = end.x - theme.px(8);
    const float top = corner.y + 0.5f * (height - theme.body->FontSize);
    const float small_top = top + theme.body->Ascent - theme.small->Ascent;
    if (reference) {
        right -= text_width(*theme.small, "reference");
        add_text(list, *theme.small, {right, small_top}, theme.palette.accent, "reference");
        right -= theme.px(8);
    }
    const ImFont& font = selected ? *theme.bold : *theme.body;
    const std::string shown = fitted(font, name, right - x);
    add_text(list, font, {x, top}, theme.palette.text, shown);
    x += text_width(font, shown) + theme.px(8);
    if (right - x > theme.px(30))
        add_text(list, *theme.small, {x, small_top}, theme.palette.text_dim,
                 fitted(*theme.small, differs, right - x));
}

void LaneList::draw(const LaneNames& names) {
    const Setup& setup = run_.setup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, ui_.theme.px(2)));
    for (std::size_t k = 0; k < setup.lanes.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        const int id = run_.ids()[k];
        if (id != RunView::unknown && id == name_.id) {
            name_field(k);
        } else {
            row(k, names.name(k), names.difference(k));
        }
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    ImGui::Dummy({0, ui_.theme.px(1)});
}

}  // namespace whorl::app
