#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/panels/measure_tabs.h"
#include "app/panels/widgets.h"
#include "app/plot/ticks.h"

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

constexpr Column columns[] = {
    {"smoke %", "Total smoke: what is left of what was put in. Best nearest to 100 %.  [thesis eq. 5.5]",
     [](const Measures& m) { return m.density_percent; }, Best::NearestHundred},
    {"energy", "Kinetic energy, ½∫|u|².", [](const Measures& m) { return m.kinetic_energy; }, Best::None},
    {"enstrophy", "½∫ω².", [](const Measures& m) { return m.enstrophy; }, Best::None},
    {"min ρ", "Smallest density.", [](const Measures& m) { return m.min_density; }, Best::None},
    {"max ρ", "Largest density.", [](const Measures& m) { return m.max_density; }, Best::None},
    {"L1", "Mean error against the exact solution or the reference lane. Best least.  [thesis eq. 5.4]",
     [](const Measures& m) { return m.errors.L1; }, Best::Least},
    {"L2", "Root of the mean square error. Best least.  [thesis eq. 5.6]",
     [](const Measures& m) { return m.errors.L2; }, Best::Least},
    {"L∞", "Largest error. Best least.  [thesis eq. 5.7]", [](const Measures& m) { return m.errors.Linf; },
     Best::Least},
    {"ν eff.", "Effective viscosity of the last step's advection, length²/time. Best nearest to 0.",
     [](const Measures& m) { return m.effective_viscosity; }, Best::NearestZero},
    {"ms/step", "Milliseconds that the last step took. Best least.",
     [](const Measures& m) { return m.ms.total; }, Best::Least},
};
constexpr int column_count = static_cast<int>(std::size(columns));

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
    const Measures* measures;
};

/// The smallest badness of a column among lanes that compete: the one that others are measured against does
/// not.
double best_of(const Column& column, const std::vector<Row>& rows, int reference) {
    double best = INFINITY;
    for (const Row& row : rows) {
        if (static_cast<int>(row.place) == reference) continue;
        best = std::fmin(best, badness(column.best, column.value(*row.measures)));
    }
    return best;
}

/// Sorted as the table's heads say; lanes without a value come last.
void sort(std::vector<Row>& rows) {
    const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    if (specs == nullptr || specs->SpecsCount == 0) return;
    const ImGuiTableColumnSortSpecs& by = specs->Specs[0];
    const bool down = by.SortDirection == ImGuiSortDirection_Descending;
    if (by.ColumnIndex == 0) {
        if (down) std::reverse(rows.begin(), rows.end());
        return;
    }
    const Column& column = columns[by.ColumnIndex - 1];
    std::stable_sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) {
        const double x = column.value(*a.measures);
        const double y = column.value(*b.measures);
        if (std::isnan(x) || std::isnan(y)) return !std::isnan(x) && std::isnan(y);
        return down ? x > y : x < y;
    });
}

void heads(PanelContext& context) {
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int k = 0; k <= column_count; ++k) {
        ImGui::TableSetColumnIndex(k);
        const char* label = k == 0 ? "Lane" : columns[k - 1].label;
        ImGui::TableHeader(label);
        const std::string key = "table=" + std::string(label);
        context.trace.control(key);
        context.help.item(context.theme, key,
                          {label, k == 0 ? "In the order of the lanes." : columns[k - 1].help,
                           "Click to sort.", "", ""});
    }
}

void lane_cell(PanelContext& context, std::size_t place, const std::string& title) {
    const Theme& theme = context.theme;
    const float side = theme.px(9);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + 0.5f * ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, middle - 0.5f * side}, {at.x + side, middle + 0.5f * side},
                                              theme.lane(static_cast<int>(place)), theme.px(2));
    ImGui::SetCursorScreenPos({at.x + side + theme.px(6), at.y});
    text(theme.palette.text, fitted(title, theme.px(104)));
    const std::string key = "table-lane=" + std::to_string(place);
    context.help.item(theme, key, {title, "", "", "", ""});
}

void value_cell(PanelContext& context, double value, bool best) {
    const Theme& theme = context.theme;
    const std::string shown = std::isnan(value) ? "–" : figure(value, 4);
    ImGui::PushFont(theme.mono);
    const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(shown.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, free));
    if (best)
        ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, faded(theme.palette.accent, 0.24f));
    text(best ? theme.palette.text : std::isnan(value) ? theme.palette.text_dim : theme.palette.text, shown);
    ImGui::PopFont();
}

}  // namespace

void draw_table_tab(PanelContext& context) {
    const Theme& theme = context.theme;
    const SessionSnapshot& moment = context.remote.session();
    const std::vector<std::string>& titles = context.measures.titles.of(moment.setup);
    std::vector<Row> rows;
    for (std::size_t k = 0; k < moment.lanes.size(); ++k) rows.push_back({k, &moment.lanes[k].measures});

    constexpr ImGuiTableFlags flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollX |
                                      ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                      ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings;
    const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    const float height =
        line * static_cast<float>(rows.size() + 1) + ImGui::GetStyle().ScrollbarSize + theme.px(6);
    if (ImGui::BeginTable("lanes", column_count + 1, flags, {0, height})) {
        ImGui::TableSetupScrollFreeze(1, 1);
        ImGui::TableSetupColumn("Lane", ImGuiTableColumnFlags_DefaultSort | ImGuiTableColumnFlags_WidthFixed,
                                theme.px(124));
        for (const Column& column : columns)
            ImGui::TableSetupColumn(column.label, ImGuiTableColumnFlags_WidthFixed, theme.px(72));
        heads(context);
        sort(rows);
        double best[column_count];
        for (int k = 0; k < column_count; ++k) best[k] = best_of(columns[k], rows, moment.setup.reference);
        for (const Row& row : rows) {
            ImGui::TableNextRow();
            ImGui::TableSetColumnIndex(0);
            lane_cell(context, row.place, titles[row.place]);
            for (int k = 0; k < column_count; ++k) {
                ImGui::TableSetColumnIndex(k + 1);
                const double value = columns[k].value(*row.measures);
                const bool marked = rows.size() > 1 && badness(columns[k].best, value) == best[k] &&
                                    static_cast<int>(row.place) != moment.setup.reference;
                value_cell(context, value, marked);
            }
        }
        ImGui::EndTable();
    }
    context.trace.control("table");
    ImGui::PushFont(theme.small);
    ImGui::PushTextWrapPos(0);
    text(theme.palette.text_dim,
         rows.size() > 1 ? "Click a head to sort, rest on it for what it means. The best of a column is marked, "
                           "where one value is better than another."
                         : "Add lanes to compare. Rest on a head for what it means.");
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

}  // namespace whorl::app
