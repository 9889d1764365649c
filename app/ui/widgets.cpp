#include "app/ui/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace whorl::app {
namespace {

float width_of(std::string_view text) {
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
}

/// The label of the newest row, until its first item has asked for it.
struct RowLabel {
    ImVec2 low{}, high{};
    int frame = -1;
    ImGuiID window = 0;
} newest_label;

}  // namespace

float label_width() {
    return std::max(0.40f * ImGui::GetContentRegionAvail().x, 6.0f * ImGui::GetFontSize());
}

void text(ImU32 colour, std::string_view line) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(line.data(), line.data() + line.size());
    ImGui::PopStyleColor();
}

bool on_row_label() {
    const RowLabel label = std::exchange(newest_label, {});
    return label.frame == ImGui::GetFrameCount() && label.window == ImGui::GetCurrentWindow()->ID &&
           ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(label.low, label.high);
}

void row_label(const Theme& theme, std::string_view label) {
    const float left = ImGui::GetCursorPosX();
    const float width = label_width();
    ImGui::AlignTextToFramePadding();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    text(theme.palette.text_dim, fitted(label, width - theme.px(4)));
    newest_label = {corner,
                    {corner.x + width, corner.y + ImGui::GetFrameHeight()},
                    ImGui::GetFrameCount(),
                    ImGui::GetCurrentWindow()->ID};
    ImGui::SameLine(left + width);
    ImGui::SetNextItemWidth(-FLT_MIN);
}

std::string fitted(std::string_view line, float width) {
    if (width_of(line) <= width) return std::string(line);
    const float room = width - width_of("…");
    while (!line.empty() && width_of(line) > room) {
        do {
            line.remove_suffix(1);
        } while (!line.empty() && continues(line.back()) && width_of(line) > room);
    }
    while (!line.empty() && continues(line.back())) line.remove_suffix(1);
    if (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0) == 0xc0) line.remove_suffix(1);
    return std::string(line) + "…";
}

bool heading(const Theme& theme, const char* title, bool open_at_first) {
    bool& open = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID(title), open_at_first);
    ImGui::Dummy({0, theme.px(3)});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton(title, {width, height})) open = !open;
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = corner.y + 0.5f * height;
    list.AddText(theme.bold, theme.bold->FontSize, {corner.x, middle - 0.5f * theme.bold->FontSize},
                 theme.palette.text, title);
    // A chevron at the right: down where it is open.
    const ImU32 colour = hovered ? theme.palette.text : theme.palette.text_dim;
    const float arm = theme.px(4);
    const ImVec2 tip{corner.x + width - theme.px(9), middle};
    const float half = 0.5f * arm;
    const ImVec2 down[] = {{tip.x - arm, tip.y - half}, {tip.x, tip.y + half}, {tip.x + arm, tip.y - half}};
    const ImVec2 right[] = {{tip.x - half, tip.y - arm}, {tip.x + half, tip.y}, {tip.x - half, tip.y + arm}};
    list.AddPolyline(open ? down : right, 3, colour, 0, theme.px(1.5f));
    return open;
}

std::vector<float> shared_widths(std::span<const char* const> labels, float room, float gap) {
    std::vector<float> widths;
    float free = room - gap * (static_cast<float>(labels.size()) - 1);
    for (const char* label : labels) {
        widths.push_back(width_of(label));
        free -= widths.back();
    }
    for (float& width : widths) width = std::floor(width + free / static_cast<float>(labels.size()));
    return widths;
}

float chip_width(int count) {
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    return std::floor((ImGui::GetContentRegionAvail().x + gap) / static_cast<float>(count) - gap);
}

bool chip(const Theme& theme, const char* label, bool chosen, float width) {
    const Palette& p = theme.palette;
    ImGui::PushStyleColor(ImGuiCol_Button, chosen ? p.accent : p.frame);
    if (chosen) {
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, p.accent);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, p.accent);
        ImGui::PushStyleColor(ImGuiCol_Text, p.accent_text);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(2), ImGui::GetStyle().FramePadding.y));
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(chosen ? 4 : 1);
    return pressed;
}

namespace {

/// Writes a slider's value into its frame, on the side where its grab is not.
void write_value(const Theme& theme, const std::string& number, std::string_view unit, double place) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float pad = ImGui::GetStyle().FramePadding.x;
    const std::string with_unit = unit.empty() ? number : number + " " + std::string(unit);
    const bool fits = width_of(with_unit) < 0.46f * (high.x - low.x) - pad;
    const std::string& shown = fits ? with_unit : number;
    const float x = place < 0.5 ? high.x - pad - width_of(shown) : low.x + pad;
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
    ImGui::GetWindowDrawList()->AddText(theme.body, theme.body->FontSize,
                                        {std::floor(x), low.y + ImGui::GetStyle().FramePadding.y}, colour,
                                        shown.c_str());
}

/// Three significant digits: what a hand can set on a scale of ratios.
double rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return std::strtod(text, nullptr);
}

/// Where a value is between a slider's ends, from 0 to 1.
double place_of(double value, SliderRange range) {
    return range.logarithmic ? std::log(value / range.min) / std::log(range.max / range.min)
                             : (value - range.min) / (range.max - range.min);
}

/// ImGui's slider without its text, which it puts under the grab; typing into it shows text all the same.
template <class T>
bool bare_slider(const char* id, ImGuiDataType type, T& value, SliderRange range, const char* format,
                 bool& typing) {
    const T min = static_cast<T>(range.min);
    const T max = static_cast<T>(range.max);
    typing = ImGui::TempInputIsActive(ImGui::GetID(id));
    if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, 0);
    const bool changed =
        ImGui::SliderScalar(id, type, &value, &min, &max, format,
                            range.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    if (!typing) ImGui::PopStyleColor();
    return changed;
}

}  // namespace

bool slider(const Theme& theme, const char* id, double& value, SliderRange range, std::string_view unit,
            const char* format) {
    bool typing = false;
    // ImGui takes what lies below the format's last digit for 0: on a scale of ratios that must be far down.
    const bool changed =
        bare_slider(id, ImGuiDataType_Double, value, range, range.logarithmic ? "%.9g" : format, typing);
    if (changed && !typing && range.logarithmic) value = rounded(value);
    char number[32];
    std::snprintf(number, sizeof number, format, value);
    if (!typing) write_value(theme, number, unit, place_of(value, range));
    return changed;
}

bool slider(const Theme& theme, const char* id, int& value, SliderRange range, std::string_view unit) {
    bool typing = false;
    const bool changed = bare_slider(id, ImGuiDataType_S32, value, range, "%d", typing);
    if (!typing) write_value(theme, std::to_string(value), unit, place_of(value, range));
    return changed;
}

bool list_item(const char* label, bool chosen) {
    const bool taken = ImGui::Selectable(label, chosen);
    if (chosen) ImGui::SetItemDefaultFocus();
    return taken;
}

bool check(const char* label, bool value) {
    return ImGui::Checkbox(label, &value);
}

}  // namespace whorl::app
