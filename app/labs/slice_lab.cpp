// The curves along a line through the field, of all lanes or of all interpolations.

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/labs/canvas.h"
#include "app/labs/lab_widgets.h"
#include "app/labs/list.h"
#include "app/labs/shown_interpolations.h"
#include "app/labs/slice.h"
#include "app/labs/slice_state.h"
#include "app/render/text.h"
#include "app/run/run_control.h"
#include "app/run/shared_state.h"
#include "app/ui/ui.h"
#include "app/views/lane_fields.h"

namespace whorl::app {
namespace {

/// A curve with the cells that it goes between.
struct Drawn {
    std::string_view label;
    ImU32 colour;
    SliceCurve curve{};
    SliceCurve cells{};  ///< none where another curve has the same
    bool exact = false;
};

/// Enough samples to look smooth, and no more than a screen shows.
int samples_per_cell(double cells) {
    return static_cast<int>(std::clamp(1200 / cells, 2.0, 24.0));
}

std::string ends_text(WorldPoint from, WorldPoint to) {
    char line[96];
    std::snprintf(line, sizeof line, "(%.2f, %.2f) to (%.2f, %.2f)", from.x, from.y, to.x, to.y);
    return line;
}

/// A curve's value at the sample nearest to x.
std::optional<double> value_at(const SliceCurve& curve, double x) {
    if (curve.x.empty()) return std::nullopt;
    const auto above = std::lower_bound(curve.x.begin(), curve.x.end(), static_cast<float>(x));
    const auto k =
        std::min<std::size_t>(static_cast<std::size_t>(above - curve.x.begin()), curve.x.size() - 1);
    if (std::isnan(curve.y[k])) return std::nullopt;
    return static_cast<double>(curve.y[k]);
}

/// @param alike  dots are in one colour: all curves have the same cells
/// All curves, the exact ones dashed over the others, and dots at the cells where they lie apart.
void draw_curves(const Theme& theme, const Canvas& canvas, const std::vector<Drawn>& all, bool alike) {
    for (std::size_t k = all.size(); k-- > 0;) {
        if (!all[k].exact)
            canvas.curve(all[k].curve.x, all[k].curve.y, all[k].colour, curve_thickness(theme));
    }
    for (const Drawn& one : all) {
        if (!one.exact) continue;
        std::vector<ImVec2> points;
        for (std::size_t k = 0; k < one.curve.x.size(); ++k) {
            if (std::isfinite(one.curve.y[k]))
                points.push_back(
                    canvas.pixel(static_cast<double>(one.curve.x[k]), static_cast<double>(one.curve.y[k])));
        }
        canvas.dashes(points, one.colour);
    }
    for (std::size_t k = all.size(); k-- > 0;) {
        const SliceCurve& cells = all[k].cells;
        if (cells.x.size() > 1 && canvas.frame().to_x(static_cast<double>(cells.x[1])) -
                                          canvas.frame().to_x(static_cast<double>(cells.x[0])) <
                                      theme.px(6))
            continue;
        const ImU32 colour = alike ? theme.palette.text : all[k].colour;
        for (std::size_t c = 0; c < cells.x.size(); ++c) {
            if (std::isfinite(cells.y[c]))
                canvas.mark(static_cast<double>(cells.x[c]), static_cast<double>(cells.y[c]), theme.px(2.5f),
                            colour);
        }
    }
}

/// The hairline, and where the curves cross it.
void draw_pointed(const Theme& theme, const Canvas& canvas, const std::vector<Drawn>& all, double x) {
    draw_hairline(*ImGui::GetWindowDrawList(), theme, canvas.frame(), x);
    for (const Drawn& one : all) {
        if (const auto value = value_at(one.curve, x)) canvas.dot(x, *value, theme.px(3), one.colour);
    }
}

class SliceLab final : public Lab {
  public:
    SliceLab(Ui& ui, const RunView& run, const LaneFields& fields, Slice& slice)
        : ui_(ui), run_(run), fields_(fields), slice_(slice) {}

    bool& open() override { return slice_.open; }
    void draw() override {
        line_controls();
        if (slice_.compares_interpolations) interpolation_controls();
        std::vector<Drawn> all;
        if (slice_.compares_interpolations) {
            add_interpolations(all);
        } else {
            add_lanes(all);
        }
        add_exact(all);
        slice_plot(all, std::max(ImGui::GetContentRegionAvail().y, ui_.theme.px(140)));
    }

  private:
    Drawn drawn(std::size_t lane, const SchemeSet& schemes) {
        const Snapshot& snapshot = run_.session().lanes[lane];
        const Field& field = *fields_.of(lane);
        const Field& filled = filled_.of(lane, snapshot, field, fields_.version());
        Drawn made;
        made.curve = curve_along(filled, snapshot, slice_.line, schemes,
                                 samples_per_cell(place_line(slice_.line, snapshot.grid()).cells()));
        made.cells = cells_along(field, snapshot, slice_.line);
        return made;
    }

    /// Every lane by its own interpolation.
    void add_lanes(std::vector<Drawn>& all) {
        for (std::size_t k = 0; k < run_.names().size(); ++k) {
            if (fields_.of(k) == nullptr) continue;
            const Scene& scene = run_.session().lanes[k].scene;
            all.push_back(drawn(k, scene.scalars));
            const bool several = run_.names().size() > 1;
            all.back().label =
                several ? std::string_view(run_.names().name(k)) : scene.scalars.interpolation.info().label;
            all.back().colour = ui_.theme.lane(static_cast<int>(k));
        }
    }

    /// The selected lane by every interpolation that is shown.
    void add_interpolations(std::vector<Drawn>& all) {
        const std::size_t lane = run_.selected();
        if (fields_.of(lane) == nullptr) return;
        for (std::size_t k = 0; k < shown_.size(); ++k) {
            if (!shown_[k]) continue;
            SchemeSet schemes = run_.session().lanes[lane].scene.scalars;
            schemes.interpolation = Id<Interpolation>::at(k);
            schemes.clamped = clamped_;
            all.push_back(drawn(lane, schemes));
            if (all.size() > 1) all.back().cells = {};
            all.back().label = schemes.interpolation.info().label;
            all.back().colour = interpolation_colour(ui_.theme, k);
        }
    }

    /// The selected lane by the exact solution, straight between the cells that it is known at.
    void add_exact(std::vector<Drawn>& all) {
        const Snapshot& selected = run_.snapshot();
        if (!selected.has_exact || &fields_.view() != views().front() || fields_.difference()) return;
        const Field& filled = filled_exact_.of(run_.selected(), selected, selected.exact, fields_.version());
        SchemeSet straight;
        straight.interpolation = linear;
        Drawn exact{.label = "exact", .colour = ui_.theme.palette.text, .exact = true};
        exact.curve = curve_along(filled, selected, slice_.line, straight,
                                  samples_per_cell(place_line(slice_.line, selected.grid()).cells()));
        all.push_back(std::move(exact));
    }

    void line_chips(bool flat) {
        const float width = std::max(std::floor(0.7f * chip_width(6)), ui_.theme.px(64));
        const char* warning = flat ? "A one-dimensional run is a line already." : "";
        if (ui_.chip_in_row("slice=row", flat || slice_.line.horizontal(), width, true,
                            {"Row", "Lays the line along the middle row of cells.",
                             "Drag its ends, or all of it, on the field", "", warning}))
            slice_.line = SliceLine::row();
        if (ui_.chip_in_row("slice=column", !flat && slice_.line.vertical(), width, false,
                            {"Column", "Lays the line along the middle column of cells.",
                             "Drag its ends, or all of it, on the field", "", warning}))
            slice_.line = SliceLine::column();
    }

    void subject_chips(float width) {
        if (ui_.chip_in_row("slice=lanes", !slice_.compares_interpolations, width, true,
                            {"Lanes", "Every lane in its colour, by its own interpolation.", "", "", ""}))
            slice_.compares_interpolations = false;
        if (ui_.chip_in_row(
                "slice=interpolations", slice_.compares_interpolations, width, false,
                {"Interpolations", "The selected lane's cells by every interpolation chosen below.", "",
                 "thesis sec. 3.1, app. A", ""}))
            slice_.compares_interpolations = true;
    }

    void ends_readout() {
        const Theme& theme = ui_.theme;
        const GridLine line = place_line(slice_.line, run_.snapshot().grid());
        ImGui::PushFont(theme.mono);
        ImGui::AlignTextToFramePadding();
        text(theme.palette.text_dim, ends_text(line.world(0), line.world(1)));
        ImGui::PopFont();
        ui_.explain("slice-ends", {"The line's ends", "From the full disc on the field to the hollow one.",
                                   "x and y in length units from the lower left corner", "", ""});
    }

    void line_controls() {
        const Theme& theme = ui_.theme;
        const Grid& grid = run_.snapshot().grid();
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float subject = std::max(chip_width(5), theme.px(100));
        const float right = ImGui::GetContentRegionMax().x - 2 * subject - std::floor(0.5f * gap);
        line_chips(grid.dimensions() == 1);
        ImGui::SameLine();
        const WorldPoint corner{grid.width(), grid.height()};
        const float longest = text_width(*theme.mono, ends_text(corner, corner));
        const bool beside = longest + gap <= right - ImGui::GetCursorPosX();
        if (beside) ends_readout();
        ImGui::SameLine(right);
        subject_chips(subject);
        if (!beside) ends_readout();
    }

    void interpolation_controls() {
        constexpr int columns = 4;
        const float width = chip_width(columns);
        for (std::size_t k = 0; k < shown_.size(); ++k) {
            const SchemeInfo& info = Id<Interpolation>::at(k).info();
            if (k % columns != 0) ImGui::SameLine(0, std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x));
            if (legend_toggle(ui_, "slice-scheme=" + std::string(info.key), info,
                              interpolation_colour(ui_.theme, k), shown_[k], width))
                shown_[k] = !shown_[k];
        }
        if (ui_.check("Clamped", "slice-clamped", clamped_,
                      {"Clamped", "Cuts what an interpolation gives to the nodes that enclose the place.", "",
                       "thesis eq. 3.8", ""}))
            clamped_ = !clamped_;
    }

    void slice_plot(const std::vector<Drawn>& all, float height) {
        const Theme& theme = ui_.theme;
        const Grid& grid = run_.snapshot().grid();
        const bool flat = grid.dimensions() == 1;
        const std::string title = shown_quantity(fields_, run_.names()) + (flat ? "" : " along the line");
        std::vector<LegendEntry> legend;
        std::vector<ValueRow> rows;
        Extent extent;
        for (const Drawn& one : all) {
            if (!slice_.compares_interpolations || one.exact) legend.push_back({one.label, one.colour});
            extent.add(one.curve.y);
            extent.add(one.cells.y);
        }
        Plot plot;
        plot.title = title;
        plot.unit = fields_.view().unit;
        plot.x_name = flat ? "x" : "distance";
        plot.size = {0, height};
        const double length = place_line(slice_.line, grid).length();
        const Canvas canvas(theme, plot, legend, {0, length}, extent.fitted());
        ui_.log.control("slice-plot");
        slice_.pointed_in_plot.reset();
        if (!canvas) return;
        draw_curves(theme, canvas, all, slice_.compares_interpolations);
        if (slice_.pointed_on_field) draw_pointed(theme, canvas, all, *slice_.pointed_on_field * length);
        if (!canvas.hovered()) return;
        const double x = canvas.pointer_x();
        slice_.pointed_in_plot = x / length;
        draw_pointed(theme, canvas, all, x);
        for (const Drawn& one : all) rows.push_back({one.label, one.colour, value_at(one.curve, x)});
        canvas.values(x, rows);
    }

    Ui& ui_;
    const RunView& run_;
    const LaneFields& fields_;
    Slice& slice_;
    ShownInterpolations shown_ = all_interpolations();
    bool clamped_ = false;
    FilledFields filled_;
    FilledFields filled_exact_;  ///< solutions, by the lane that knows them
};

}  // namespace

const LabEntry slice_lab{
    .key = "slice",
    .label = "Slice",
    .help = "What is shown, along a line through the field: overshoot, flattening and lag as curves.",
    .source = "",
    .width = 760,
    .height = 400,
    .anchor = LabEntry::Anchor::Bottom,
    .make = [](const Services& s) -> std::unique_ptr<Lab> {
        return std::make_unique<SliceLab>(s.ui, s.run, s.fields, s.shared.of<Slice>());
    }};

}  // namespace whorl::app
