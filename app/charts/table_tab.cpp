#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/charts/measure_tabs.h"
#include "app/ui/widgets.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

/// Steps that a median is taken over.
constexpr std::size_t median_of = 60;

/// Few columns fit the width: the measures come in several tables.
struct Group {
    std::string title;
    std::vector<const Measure*> columns;
};

/// Groups in the order of the list of measures, but that errors follow the smoke.
std::vector<Group> groups() {
    std::vector<Group> all{{"Smoke", {}}, {"Error", {}}};
    for (const Measure* measure : measures().all()) {
        const std::string& title = measure->column.group;
        if (title.empty()) continue;
        const auto same =
            std::find_if(all.begin(), all.end(), [&](const Group& group) { return group.title == title; });
        Group& group = same == all.end() ? all.emplace_back(Group{title, {}}) : *same;
        group.columns.push_back(measure);
    }
    return all;
}

/// What a column's head says on hover.
std::string help(const Measure& measure) {
    std::string text = measure.help;
    if (measure.mean == Mean::Median) text += ": the median of the last " + std::to_string(median_of);
    text += ".";
    if (measure.best == Best::Least) text += " Best least.";
    if (measure.best == Best::NearestZero) text += " Best nearest to 0.";
    if (measure.best == Best::NearestHundred) text += " Best nearest to 100 %.";
    return measure.source.empty() ? text : text + "  [" + measure.source + "]";
}

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

/// A lane.
struct Row {
    std::size_t place;
    const Measures& measured;
    const LaneHistory& history;

    double value(const Measure& measure) const {
        return measure.mean == Mean::Median ? history.median(measure, median_of) : measure.of(measured);
    }
};

/// The smallest badness of a column among lanes that compete: the one that others are measured against does
/// not.
double best_of(const Measure& measure, const std::vector<Row>& rows, int reference) {
    double best = INFINITY;
    for (const Row& row : rows) {
        if (static_cast<int>(row.place) == reference) continue;
        best = std::fmin(best, badness(measure.best, row.value(measure)));
    }
    return best;
}

/// Sorted as the table's heads say; lanes without a value come last.
void sort(std::vector<const Row*>& rows, const std::vector<const Measure*>& columns) {
    const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
    if (specs == nullptr || specs->SpecsCount == 0) return;
    const ImGuiTableColumnSortSpecs& by = specs->Specs[0];
    const bool down = by.SortDirection == ImGuiSortDirection_Descending;
    if (by.ColumnIndex == 0) {
        if (down) std::reverse(rows.begin(), rows.end());
        return;
    }
    const Measure& measure = *columns[static_cast<std::size_t>(by.ColumnIndex - 1)];
    std::stable_sort(rows.begin(), rows.end(), [&](const Row* a, const Row* b) {
        const double x = a->value(measure);
        const double y = b->value(measure);
        if (std::isnan(x) || std::isnan(y)) return !std::isnan(x) && std::isnan(y);
        return down ? x > y : x < y;
    });
}

/// The arrow of a sorted column, as ImGui draws it at the right end of the head.
float arrow_width() {
    return std::ceil(0.65f * ImGui::GetFontSize()) + ImGui::GetStyle().FramePadding.x;
}

/// Of a column of numbers, pixels: its head with the arrow, and four digits with an exponent.
float number_width(const Theme& theme, const std::string& label) {
    return std::max(std::ceil(ImGui::CalcTextSize(label.c_str()).x) + arrow_width(), theme.px(46));
}

class TableTab final : public Tab {
  public:
    TableTab(Ui& ui, const RunView& run, const History& history) : ui_(ui), run_(run), history_(history) {}

    void draw() override {
        const Theme& theme = ui_.theme;
        const SessionSnapshot& session = run_.session();
        for (const Group& group : groups()) {
            const bool of_errors =
                std::all_of(group.columns.begin(), group.columns.end(),
                            [](const Measure* measure) { return measure->needs == Needs::Reference; });
            if (of_errors && !has_errors(session)) continue;
            draw_group(group);
        }
        ImGui::PushFont(theme.small);
        ImGui::PushTextWrapPos(0);
        text(theme.palette.text_dim, session.lanes.size() > 1
                                         ? "Click a head to sort, rest on it for what it means. The best of "
                                           "a column is marked, where one "
                                           "value is better than another."
                                         : "Add lanes to compare. Rest on a head for what it means.");
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }

  private:
    /// Numbers have heads that are right-aligned as they are. ImGui's own would leave room for the arrow
    /// always.
    void head(const std::string& table, const std::string& label, const std::string& help, bool numbers) {
        const bool sorted = (ImGui::TableGetColumnFlags() & ImGuiTableColumnFlags_IsSorted) != 0;
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(label.c_str()).x;
        ImGui::TableHeader(("##" + label).c_str());
        const std::string key = table + "=" + label;
        ui_.log.control(key);
        ui_.tooltip.item(ui_.theme, key, {label, help, "Click to sort.", "", ""});
        const float left = numbers ? std::max(0.0f, free - (sorted ? arrow_width() : 0)) : 0;
        ImGui::GetWindowDrawList()->AddText({std::floor(corner.x + left), corner.y}, ui_.theme.palette.text,
                                            label.c_str());
    }

    /// The lanes' column takes what the numbers leave.
    void heads(const Group& group) {
        const Theme& theme = ui_.theme;
        ImGui::PushFont(theme.small);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                            ImVec2(theme.px(2), ImGui::GetStyle().FramePadding.y));
        ImGui::TableSetupColumn(group.title.c_str(),
                                ImGuiTableColumnFlags_WidthStretch | ImGuiTableColumnFlags_DefaultSort);
        for (const Measure* measure : group.columns)
            ImGui::TableSetupColumn(
                measure->head().c_str(),
                ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_PreferSortDescending,
                number_width(theme, measure->head()));
        ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
        ImGui::TableSetColumnIndex(0);
        head(group.title, group.title, "In the order of the lanes.", false);
        for (std::size_t k = 0; k < group.columns.size(); ++k) {
            ImGui::TableSetColumnIndex(static_cast<int>(k + 1));
            head(group.title, group.columns[k]->head(), help(*group.columns[k]), true);
        }
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }

    void lane_cell(std::size_t place, const std::string& title) {
        const Theme& theme = ui_.theme;
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
        ui_.tooltip.item(theme, key, {title, "", "", "", ""});
    }

    /// As many digits as there is room for.
    void value_cell(double value, bool best) {
        const Theme& theme = ui_.theme;
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

    void draw_group(const Group& group) {
        const SessionSnapshot& session = run_.session();
        std::vector<Row> rows;
        for (std::size_t k = 0; k < session.lanes.size(); ++k)
            rows.push_back({k, session.lanes[k].measures, history_.lane(session.ids[k])});
        std::vector<const Row*> sorted;
        for (const Row& row : rows) sorted.push_back(&row);

        constexpr ImGuiTableFlags flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_RowBg |
                                          ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_SizingFixedFit |
                                          ImGuiTableFlags_NoSavedSettings;
        const Theme& theme = ui_.theme;
        ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(theme.px(3), ImGui::GetStyle().CellPadding.y));
        const bool open =
            ImGui::BeginTable(group.title.c_str(), static_cast<int>(group.columns.size()) + 1, flags);
        ImGui::PopStyleVar();
        if (!open) return;
        heads(group);
        sort(sorted, group.columns);
        for (const Row* row : sorted) {
            ImGui::TableNextRow();
            ImGui::TableSetColumnIndex(0);
            lane_cell(row->place, run_.names().name(row->place));
            for (std::size_t k = 0; k < group.columns.size(); ++k) {
                const Measure& measure = *group.columns[k];
                ImGui::TableSetColumnIndex(static_cast<int>(k + 1));
                const double value = row->value(measure);
                const bool competes =
                    rows.size() > 1 && static_cast<int>(row->place) != session.setup.reference;
                const bool best = competes && badness(measure.best, value) ==
                                                  best_of(measure, rows, session.setup.reference);
                value_cell(value, best);
            }
        }
        ImGui::EndTable();
        ImGui::Dummy({0, ui_.theme.px(6)});
    }

    Ui& ui_;
    const RunView& run_;
    const History& history_;
};

}  // namespace

std::unique_ptr<Tab> make_table_tab(Ui& ui, const RunView& run, const History& history) {
    return std::make_unique<TableTab>(ui, run, history);
}

}  // namespace whorl::app
