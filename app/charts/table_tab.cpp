#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/charts/measure_tabs.h"
#include "app/ui/widgets.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

/// A measure of a lane as a column.
struct Column {
    enum class Best { None, Least, NearestZero, NearestHundred };

    const char* label;
    const char* help;
    double (*value)(const Measures&);
    Best best;
};

using Best = Column::Best;

constexpr Column smoke[] = {
    {"total, %", "Total smoke: what is left of what was put in. Best nearest to 100 %.  [thesis eq. 5.5]",
     [](const Measures& m) { return m.density_percent; }, Best::NearestHundred},
    {"min", "Smallest density.", [](const Measures& m) { return m.min_density; }, Best::None},
    {"max", "Largest density.", [](const Measures& m) { return m.max_density; }, Best::None},
};
constexpr Column error[] = {
    {"L1", "Mean error against the exact solution or the reference lane. Best least.  [thesis eq. 5.4]",
     [](const Measures& m) { return m.errors.L1; }, Best::Least},
    {"L2", "Root of the mean square error. Best least.  [thesis eq. 5.6]",
     [](const Measures& m) { return m.errors.L2; }, Best::Least},
    {"L∞", "Largest error. Best least.  [thesis eq. 5.7]", [](const Measures& m) { return m.errors.Linf; },
     Best::Least},
};
constexpr Column flow[] = {
    {"energy", "Kinetic energy, ½∫|u|².", [](const Measures& m) { return m.kinetic_energy; }, Best::None},
    {"enstrophy", "½∫ω².", [](const Measures& m) { return m.enstrophy; }, Best::None},
    {"visc.", "Effective viscosity of the last step's advection, length²/time. Best nearest to 0.",
     [](const Measures& m) { return m.effective_viscosity; }, Best::NearestZero},
};
constexpr Column cost[] = {
    {"ms a step", "Milliseconds that a step took: the median of the last 60. Best least.",
     [](const Measures& m) { return m.ms.total; }, Best::Least},
};

constexpr std::size_t median_of = 60;

/// Few columns fit the width: the measures come in several tables.
struct Group {
    const char* title;
    std::span<const Column> columns;
};

constexpr Group groups[] = {{"Smoke", smoke}, {"Error", error}, {"Flow", flow}, {"Cost", cost}};

/// How far from best a value is; NaN where there is no best.
double badness(Best best, double value) {
    switch (best) {
        case Best::Least:
            return value;
        case Best::NearestZero:
            return std::abs(value);
        case Best::NearestHundred:
            return std::abs(value - 100);
        case Best::None:
            break;
    }
    return std::nan("");
}

struct Row {
    std::size_t place;
    Measures measures;  ///< the step's time is the median of the last ones: a single one is chance
};

/// The smallest badness of a column among lanes that compete: the one that others are measured against does
/// not.
double best_of(const Column& column, const std::vector<Row>& rows, int reference) {
    double best = INFINITY;
    for (const Row& row : rows) {
        if (static_cast<int>(row.place) == reference) continue;
        best = std::fmin(best, badness(column.best, column.value(row.measures)));
    }
    return best;
}

/// Sorted as the table's heads say; lanes without a value come last.
void sort(std::vector<Row>& rows, std::span<const Column> columns) {
    const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    if (specs == nullptr || specs->SpecsCount == 0) return;
    const ImGuiTableColumnSortSpecs& by = specs->Specs[0];
    const bool down = by.SortDirection == ImGuiSortDirection_Descending;
    if (by.ColumnIndex == 0) {
        if (down) std::reverse(rows.begin(), rows.end());
        return;
    }
    const Column& column = columns[static_cast<std::size_t>(by.ColumnIndex - 1)];
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
        const double x = column.value(a.measures);
        const double y = column.value(b.measures);
        if (std::isnan(x) || std::isnan(y)) return !std::isnan(x) && std::isnan(y);
        return down ? x > y : x < y;
    });
}

/// The arrow of a sorted column, as ImGui draws it at the right end of the head.
float arrow_width() {
    return std::ceil(0.65f * ImGui::GetFontSize()) + ImGui::GetStyle().FramePadding.x;
}

/// Numbers have heads that are right-aligned as they are. ImGui's own would leave room for the arrow always.
void head(PanelContext& context, const char* table, const char* label, const char* help, bool numbers) {
    const bool sorted = (ImGui::TableGetColumnFlags() & ImGuiTableColumnFlags_IsSorted) != 0;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(label).x;
    ImGui::TableHeader(("##" + std::string(label)).c_str());
    const std::string key = std::string(table) + "=" + label;
    context.log.control(key);
    context.tooltip.item(context.theme, key, {label, help, "Click to sort.", "", ""});
    const float left = numbers ? std::max(0.0f, free - (sorted ? arrow_width() : 0)) : 0;
    ImGui::GetWindowDrawList()->AddText({std::floor(corner.x + left), corner.y}, context.theme.palette.text,
                                        label);
}

/// Of a column of numbers, pixels: its head with the arrow, and four digits with an exponent.
float number_width(const Theme& theme, const char* label) {
    return std::max(std::ceil(ImGui::CalcTextSize(label).x) + arrow_width(), theme.px(46));
}

/// The lanes' column takes what the numbers leave.
void heads(PanelContext& context, const Group& group) {
    const Theme& theme = context.theme;
    ImGui::PushFont(theme.small);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(theme.px(2), ImGui::GetStyle().FramePadding.y));
    ImGui::TableSetupColumn(group.title,
                            ImGuiTableColumnFlags_WidthStretch | ImGuiTableColumnFlags_DefaultSort);
    for (const Column& column : group.columns)
        ImGui::TableSetupColumn(column.label,
                                ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_PreferSortDescending,
                                number_width(theme, column.label));
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableSetColumnIndex(0);
    head(context, group.title, group.title, "In the order of the lanes.", false);
    for (std::size_t k = 0; k < group.columns.size(); ++k) {
        ImGui::TableSetColumnIndex(static_cast<int>(k + 1));
        head(context, group.title, group.columns[k].label, group.columns[k].help, true);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

void lane_cell(PanelContext& context, std::size_t place, const std::string& title) {
    const Theme& theme = context.theme;
    const float side = theme.px(9);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + 0.5f * ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, middle - 0.5f * side},
                                              {at.x + side, middle + 0.5f * side},
                                              theme.lane(static_cast<int>(place)), theme.px(2));
    ImGui::SetCursorScreenPos({at.x + side + theme.px(6), at.y});
    const float room = ImGui::GetContentRegionAvail().x;
    // The colour says enough where there is no room for some letters.
    text(theme.palette.text, room > theme.px(24) ? fitted(title, room) : std::string());
    const std::string key = "table-lane=" + std::to_string(place);
    context.tooltip.item(theme, key, {title, "", "", "", ""});
}

/// As many digits as there is room for.
void value_cell(PanelContext& context, double value, bool best) {
    const Theme& theme = context.theme;
    ImGui::PushFont(theme.mono);
    const float room = ImGui::GetContentRegionAvail().x;
    std::string shown = "–";
    for (int digits = 4; digits > 1 && !std::isnan(value); --digits) {
        shown = figure(value, digits);
        if (ImGui::CalcTextSize(shown.c_str()).x <= room) break;
    }
    const float free = room - ImGui::CalcTextSize(shown.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, free));
    if (best) ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, faded(theme.palette.accent, 0.24f));
    text(std::isnan(value) ? theme.palette.text_dim : theme.palette.text, shown);
    ImGui::PopFont();
}

void draw_group(PanelContext& context, const Group& group) {
    const SessionSnapshot& moment = context.client.session();
    std::vector<Row> rows;
    for (std::size_t k = 0; k < moment.lanes.size(); ++k) {
        rows.push_back({k, moment.lanes[k].measures});
        rows.back().measures.ms.total = context.history.lane(moment.ids[k]).median(Track::TotalMs, median_of);
    }

    constexpr ImGuiTableFlags flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_RowBg |
                                      ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingFixedFit |
                                      ImGuiTableFlags_NoSavedSettings;
    const Theme& theme = context.theme;
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(theme.px(3), ImGui::GetStyle().CellPadding.y));
    const bool open = ImGui::BeginTable(group.title, static_cast<int>(group.columns.size()) + 1, flags);
    ImGui::PopStyleVar();
    if (!open) return;
    heads(context, group);
    sort(rows, group.columns);
    for (const Row& row : rows) {
        ImGui::TableNextRow();
        ImGui::TableSetColumnIndex(0);
        lane_cell(context, row.place, context.names.name(row.place));
        for (std::size_t k = 0; k < group.columns.size(); ++k) {
            const Column& column = group.columns[k];
            ImGui::TableSetColumnIndex(static_cast<int>(k + 1));
            const double value = column.value(row.measures);
            const bool competes = rows.size() > 1 && static_cast<int>(row.place) != moment.setup.reference;
            const bool best =
                competes && badness(column.best, value) == best_of(column, rows, moment.setup.reference);
            value_cell(context, value, best);
        }
    }
    ImGui::EndTable();
    ImGui::Dummy({0, context.theme.px(6)});
}

}  // namespace

void draw_table_tab(PanelContext& context) {
    const Theme& theme = context.theme;
    const SessionSnapshot& moment = context.client.session();
    for (const Group& group : groups) {
        if (group.columns.data() == error && !has_errors(moment)) continue;
        draw_group(context, group);
    }
    ImGui::PushFont(theme.small);
    ImGui::PushTextWrapPos(0);
    text(
        theme.palette.text_dim,
        moment.lanes.size() > 1
            ? "Click a head to sort, rest on it for what it means. The best of a column is marked, where one "
              "value is better than another."
            : "Add lanes to compare. Rest on a head for what it means.");
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

}  // namespace whorl::app
