// Figures 3.5 and 3.6 of the thesis, alive: data to drag, every interpolation, and its slopes.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/labs/canvas.h"
#include "app/labs/data_sets.h"
#include "app/labs/interpolation_curves.h"
#include "app/labs/interpolation_region.h"
#include "app/labs/interpolation_table.h"
#include "app/labs/list.h"
#include "app/run/shared_state.h"
#include "app/ui/ui.h"

namespace whorl::app {
namespace {

void choose(InterpolationState& lab, std::size_t data_set) {
    const DataSet& chosen = data_sets()[data_set];
    lab.data_set = data_set;
    lab.values.assign(chosen.values.begin(), chosen.values.end());
    lab.interval = chosen.interval;
    lab.dragged.reset();
}

/// The point that the pointer is on, if any.
std::optional<std::size_t> point_under(const Theme& theme, const InterpolationState& lab,
                                       const Canvas& canvas) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    for (std::size_t k = 0; k < lab.values.size(); ++k) {
        const ImVec2 at = canvas.pixel(static_cast<double>(k), static_cast<double>(lab.values[k]));
        if (std::hypot(at.x - mouse.x, at.y - mouse.y) <= theme.px(9)) return k;
    }
    return std::nullopt;
}

/// A press on a point takes it, beside one it chooses the interval; a point that is held follows.
void act(const Theme& theme, InterpolationState& lab, const Canvas& canvas) {
    if (canvas.pressed() && canvas.hovered()) {
        lab.dragged = point_under(theme, lab, canvas);
        if (!lab.dragged)
            lab.interval = std::clamp(static_cast<int>(std::floor(canvas.pointer_x())), 0,
                                      static_cast<int>(lab.values.size()) - 2);
    }
    if (!canvas.held()) lab.dragged.reset();
    if (lab.dragged) {
        const Interval& y = canvas.frame().y;
        lab.values[*lab.dragged] = static_cast<float>(std::clamp(canvas.pointer_y(), y.lo, y.hi));
    }
}

class InterpolationLab final : public Lab {
  public:
    InterpolationLab(Ui& ui, InterpolationState& state) : ui_(ui), state_(state) {}

    void draw() override {
        const Theme& theme = ui_.theme;
        if (state_.values.empty()) choose(state_, 0);
        controls();
        const Field row = row_of(state_.values);
        IntervalReports reports;
        for (std::size_t k = 0; k < state_.shown.size(); ++k)
            reports.push_back(report_on(row, Id<Interpolation>::at(k), state_.clamped, state_.interval));

        const ImVec2 room = ImGui::GetContentRegionAvail();
        const float gap = ImGui::GetStyle().ItemSpacing.y;
        const float right = std::clamp(0.4f * room.x, theme.px(330), theme.px(440));
        const float height = std::max(room.y, interpolation_table_height(theme) + theme.px(150));
        ImGui::BeginChild("curves", {room.x - right - gap, height}, false, ImGuiWindowFlags_NoScrollbar);
        const float upper = std::floor(0.56f * (height - gap));
        main_plot(curves_of(row, state_.clamped, 0, row.width() - 1), upper);
        inset(row, height - gap - upper);
        ImGui::EndChild();
        ImGui::SameLine(0, gap);
        ImGui::BeginChild("numbers", {0, height}, false, ImGuiWindowFlags_NoScrollbar);
        draw_region_plot(ui_, state_, reports, height - interpolation_table_height(theme) - gap);
        draw_interpolation_table(ui_, state_, reports);
        ImGui::EndChild();
    }

  private:
    void controls() {
        const auto count = static_cast<int>(data_sets().size());
        const float width = chip_width(count + 1);
        for (std::size_t k = 0; k < data_sets().size(); ++k) {
            const DataSet& set = data_sets()[k];
            const bool as_it_was =
                state_.data_set == k &&
                std::equal(set.values.begin(), set.values.end(), state_.values.begin(), state_.values.end());
            if (ui_.chip_in_row("interpolation-data=" + std::string(set.key), as_it_was, width, k == 0,
                                {set.label, set.help, "", set.source, ""}))
                choose(state_, k);
        }
        ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x);
        if (ui_.check("Clamped", "interpolation-clamped", state_.clamped,
                      {"Clamped", "Cuts what an interpolation gives to the interval's two points.", "",
                       "thesis eq. 3.8", ""}))
            state_.clamped = !state_.clamped;
    }

    void main_plot(const InterpolationCurves& curves, float height) {
        const Theme& theme = ui_.theme;
        Plot plot;
        plot.title = "Data and what lies between";
        plot.x_name = "x";
        plot.size = {0, height};
        if (!state_.dragged) {
            Extent extent = extent_of(state_, curves);
            extent.add(state_.values);
            state_.y = extent.fitted();
        }
        const double last = static_cast<double>(state_.values.size()) - 1;
        const Canvas canvas(theme, plot, {}, {-0.2, last + 0.2}, state_.y);
        ui_.log.control("interpolation-plot");
        if (!canvas) return;
        const bool on_point = canvas.hovered() && point_under(theme, state_, canvas);
        if (!on_point)
            ui_.tooltip.item(
                theme, "interpolation-plot",
                {"Data points", "Drag a point up or down. Click between two to choose their interval.", "",
                 "thesis fig. 3.5", ""});
        if (on_point || state_.dragged) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
        act(theme, state_, canvas);
        canvas.band(state_.interval, state_.interval + 1, faded(theme.palette.text, 0.07f));
        draw_curves(theme, state_, canvas, curves);
        draw_points(theme, state_, canvas);
        for (std::size_t k = 0; k < state_.values.size(); ++k) {
            const ImVec2 at = canvas.pixel(static_cast<double>(k), static_cast<double>(state_.values[k]));
            const float half = theme.px(9);
            ui_.log.rect("interpolation-point=" + std::to_string(k), at.x - half, at.y - half, 2 * half,
                         2 * half);
        }
    }

    /// The chosen interval alone, as the figure's inset: its extrema are seen where they are slight.
    void inset(const Field& row, float height) {
        const Theme& theme = ui_.theme;
        const std::string title =
            "Between " + std::to_string(state_.interval) + " and " + std::to_string(state_.interval + 1);
        Plot plot;
        plot.title = title;
        plot.x_name = "x";
        plot.size = {0, height};
        const InterpolationCurves curves =
            curves_of(row, state_.clamped, state_.interval, state_.interval + 1);
        const std::array ends{state_.values[static_cast<std::size_t>(state_.interval)],
                              state_.values[static_cast<std::size_t>(state_.interval) + 1]};
        Extent extent = extent_of(state_, curves);
        extent.add(ends);
        const Canvas canvas(theme, plot, {}, {state_.interval - 0.02, state_.interval + 1.02},
                            extent.tight());
        ui_.log.control("interpolation-inset");
        if (!canvas) return;
        ui_.tooltip.item(theme, "interpolation-inset",
                         {"The chosen interval",
                          "The figure's inset. Between the two lines a curve is in the "
                          "range of the interval's points.",
                          "", "thesis fig. 3.5", ""});
        for (const float end : ends) {
            const ImVec2 at = canvas.pixel(0, static_cast<double>(end));
            canvas.begin().AddLine({canvas.frame().low.x, sharp(at.y)}, {canvas.frame().high.x, sharp(at.y)},
                                   theme.palette.hairline, theme.thin());
            canvas.end();
        }
        draw_curves(theme, state_, canvas, curves);
        draw_points(theme, state_, canvas);
    }

    Ui& ui_;
    InterpolationState& state_;
};

}  // namespace

const LabEntry interpolation_lab{
    .key = "interpolation",
    .label = "Interpolation lab",
    .help = "Data points to drag, every interpolation between them, and whether its slopes keep it monotone.",
    .source = "thesis fig. 3.5, 3.6",
    .width = 980,
    .height = 700,
    .anchor = LabEntry::Anchor::Middle,
    .make = [](const Services& s) -> std::unique_ptr<Lab> {
        return std::make_unique<InterpolationLab>(s.ui, s.shared.of<InterpolationState>());
    }};

}  // namespace whorl::app
