#include "app/labs/interpolation_table.h"

#include <imgui.h>

#include <cmath>

#include "app/labs/interpolation_region.h"
#include "app/labs/lab_widgets.h"
#include "app/render/text.h"

namespace whorl::app {
namespace {

/// The columns of the table, pixels from its left edge.
struct TableColumns {
    float name, alpha, beta, verdict, end;
    TableColumns(const Theme& theme, float width)
        : name(theme.px(20)),
          alpha(width - theme.px(196)),
          beta(width - theme.px(148)),
          verdict(width - theme.px(100)),
          end(width) {}
};

void table_head(const Theme& theme, const TableColumns& columns) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto put = [&](float x, const char* line) {
        add_text(list, *theme.small, {at.x + x, at.y}, theme.palette.text_dim, line);
    };
    put(columns.name, "Interpolation");
    put(columns.alpha, "α");
    put(columns.beta, "β");
    put(columns.verdict, "in the interval");
    ImGui::Dummy({columns.end, theme.small->FontSize + theme.px(2)});
}

void table_row(Ui& ui, InterpolationState& lab, std::size_t k, const IntervalReport& report,
               const TableColumns& columns) {
    const Theme& theme = ui.theme;
    const SchemeInfo& info = Id<Interpolation>::at(k).info();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = theme.body->FontSize + theme.px(6);
    const std::string key = "interpolation-scheme=" + std::string(info.key);
    if (ImGui::InvisibleButton(key.c_str(), {columns.end, height})) lab.shown[k] = !lab.shown[k];
    const bool hovered = ImGui::IsItemHovered();
    ui.explain(key, {info.label, info.help, "Click to show it or leave it out", info.source, ""});
    if (hovered) lab.pointed = k;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered)
        list.AddRectFilled(at, {at.x + columns.end, at.y + height}, theme.palette.frame, theme.px(3));
    const float middle = std::floor(at.y + 0.5f * height);
    swatch(theme, {at.x + theme.px(9), middle}, interpolation_colour(theme, k), lab.shown[k]);
    const float strength = lab.shown[k] ? 1.0f : 0.5f;
    const float text_y = middle - 0.5f * theme.body->FontSize;
    const float small_y = middle - 0.5f * theme.small->FontSize;
    const ImU32 plain = faded(theme.palette.text, strength);
    const ImU32 dim = faded(theme.palette.text_dim, strength);
    add_text(list, *theme.body, {at.x + columns.name, text_y}, plain,
             fitted(*theme.body, info.label, columns.alpha - columns.name - theme.px(6)));
    const auto number = [&](float x, double value) {
        add_text(list, *theme.mono, {at.x + x, middle - 0.5f * theme.mono->FontSize}, plain,
                 report.flat ? "–" : signed_number(value));
    };
    number(columns.alpha, report.alpha);
    number(columns.beta, report.beta);
    const ImU32 tone = report.leaves_range() ? faded(theme.palette.accent, strength)
                       : report.turned > 0   ? plain
                                             : dim;
    add_text(list, *theme.small, {at.x + columns.verdict, small_y}, tone,
             fitted(*theme.small, report.verdict(), columns.end - columns.verdict));
}

}  // namespace

float interpolation_table_height(const Theme& theme) {
    return theme.small->FontSize + theme.px(12) +
           static_cast<float>(Interpolation::list().all().size()) * (theme.body->FontSize + theme.px(6));
}

void draw_interpolation_table(Ui& ui, InterpolationState& lab, const IntervalReports& reports) {
    const TableColumns columns(ui.theme, ImGui::GetContentRegionAvail().x);
    table_head(ui.theme, columns);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    lab.pointed.reset();
    for (std::size_t k = 0; k < reports.size(); ++k) table_row(ui, lab, k, reports[k], columns);
    ImGui::PopStyleVar();
}

}  // namespace whorl::app
