#include "app/labs/slice_window.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/labs/canvas.h"
#include "app/labs/lab_widgets.h"
#include "app/panels/field_header.h"
#include "app/render/text.h"
#include "app/ui/widgets.h"

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

Drawn drawn(const PanelContext& context, SliceLab& lab, std::size_t lane, const SchemeSet& schemes) {
    const Snapshot& snapshot = context.client.session().lanes[lane];
    const Field& field = *context.fields.of(lane);
    const Field& filled = lab.fields.of(lane, snapshot, field, context.fields.version());
    Drawn made;
    made.curve = curve_along(filled, snapshot, lab.line, schemes,
                             samples_per_cell(place_line(lab.line, snapshot.grid()).cells()));
    made.cells = cells_along(field, snapshot, lab.line);
    return made;
}

/// Every lane by its own interpolation.
void add_lanes(const PanelContext& context, SliceLab& lab, std::vector<Drawn>& all) {
    for (std::size_t k = 0; k < context.names.size(); ++k) {
        if (context.fields.of(k) == nullptr) continue;
        const Scene& scene = context.client.session().lanes[k].scene;
        all.push_back(drawn(context, lab, k, scene.scalars));
        const bool several = context.names.size() > 1;
        all.back().label =
            several ? std::string_view(context.names.name(k)) : scene.scalars.interpolation.info().label;
        all.back().colour = context.theme.lane(static_cast<int>(k));
    }
}

/// The selected lane by every interpolation that is shown.
void add_interpolations(const PanelContext& context, SliceLab& lab, std::vector<Drawn>& all) {
    const std::size_t lane = context.client.selected();
    if (context.fields.of(lane) == nullptr) return;
    for (std::size_t k = 0; k < lab.shown.size(); ++k) {
        if (!lab.shown[k]) continue;
        SchemeSet schemes = context.client.session().lanes[lane].scene.scalars;
        schemes.interpolation = Id<Interpolation>::at(k);
        schemes.clamped = lab.clamped;
        all.push_back(drawn(context, lab, lane, schemes));
        if (all.size() > 1) all.back().cells = {};
        all.back().label = schemes.interpolation.info().label;
        all.back().colour = interpolation_colour(context.theme, k);
    }
}

/// The selected lane by the exact solution, straight between the cells that it is known at.
void add_exact(const PanelContext& context, SliceLab& lab, std::vector<Drawn>& all) {
    const Snapshot& selected = context.snapshot();
    if (!selected.has_exact || &context.fields.view() != views().front() || context.fields.difference())
        return;
    const Field& filled =
        lab.exact.of(context.client.selected(), selected, selected.exact, context.fields.version());
    SchemeSet straight;
    straight.interpolation = linear;
    Drawn exact{.label = "exact", .colour = context.theme.palette.text, .exact = true};
    exact.curve = curve_along(filled, selected, lab.line, straight,
                              samples_per_cell(place_line(lab.line, selected.grid()).cells()));
    all.push_back(std::move(exact));
}

void line_chips(PanelContext& context, SliceLab& lab, bool flat) {
    const float width = std::max(std::floor(0.7f * chip_width(6)), context.theme.px(64));
    const char* warning = flat ? "A one-dimensional run is a line already." : "";
    ImGui::BeginDisabled(flat);
    if (lab_chip(context, "slice=row",
                 {"Row", "Lays the line along the middle row of cells.",
                  "Drag its ends, or all of it, on the field", "", warning},
                 flat || lab.line.horizontal(), width, true))
        lab.line = SliceLine::row();
    if (lab_chip(context, "slice=column",
                 {"Column", "Lays the line along the middle column of cells.",
                  "Drag its ends, or all of it, on the field", "", warning},
                 !flat && lab.line.vertical(), width, false))
        lab.line = SliceLine::column();
    ImGui::EndDisabled();
}

void subject_chips(PanelContext& context, SliceLab& lab, float width) {
    if (lab_chip(context, "slice=lanes",
                 {"Lanes", "Every lane in its colour, by its own interpolation.", "", "", ""},
                 !lab.compares_interpolations, width, true))
        lab.compares_interpolations = false;
    if (lab_chip(context, "slice=interpolations",
                 {"Interpolations", "The selected lane's cells by every interpolation chosen below.", "",
                  "thesis sec. 3.1, app. A", ""},
                 lab.compares_interpolations, width, false))
        lab.compares_interpolations = true;
}

std::string ends_text(WorldPoint from, WorldPoint to) {
    char line[96];
    std::snprintf(line, sizeof line, "(%.2f, %.2f) to (%.2f, %.2f)", from.x, from.y, to.x, to.y);
    return line;
}

void ends_readout(PanelContext& context, const SliceLab& lab) {
    const Theme& theme = context.theme;
    const GridLine line = place_line(lab.line, context.snapshot().grid());
    ImGui::PushFont(theme.mono);
    ImGui::AlignTextToFramePadding();
    text(theme.palette.text_dim, ends_text(line.world(0), line.world(1)));
    ImGui::PopFont();
    context.log.control("slice-ends");
    context.tooltip.item(theme, "slice-ends",
                         {"The line's ends", "From the full disc on the field to the hollow one.",
                          "x and y in length units from the lower left corner", "", ""});
}

void line_controls(PanelContext& context, SliceLab& lab) {
    const Theme& theme = context.theme;
    const Grid& grid = context.snapshot().grid();
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float subject = std::max(chip_width(5), theme.px(100));
    const float right = ImGui::GetContentRegionMax().x - 2 * subject - std::floor(0.5f * gap);
    line_chips(context, lab, grid.dimensions() == 1);
    ImGui::SameLine();
    const WorldPoint corner{grid.width(), grid.height()};
    const float longest = text_width(*theme.mono, ends_text(corner, corner));
    const bool beside = longest + gap <= right - ImGui::GetCursorPosX();
    if (beside) ends_readout(context, lab);
    ImGui::SameLine(right);
    subject_chips(context, lab, subject);
    if (!beside) ends_readout(context, lab);
}

void interpolation_controls(PanelContext& context, SliceLab& lab) {
    constexpr int columns = 4;
    const float width = chip_width(columns);
    for (std::size_t k = 0; k < lab.shown.size(); ++k) {
        const SchemeInfo& info = Id<Interpolation>::at(k).info();
        if (k % columns != 0) ImGui::SameLine(0, std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x));
        if (legend_toggle(context, "slice-scheme=" + std::string(info.key), info,
                          interpolation_colour(context.theme, k), lab.shown[k], width))
            lab.shown[k] = !lab.shown[k];
    }
    if (check("Clamped", lab.clamped)) lab.clamped = !lab.clamped;
    context.log.control("slice-clamped");
    context.tooltip.item(context.theme, "slice-clamped",
                         {"Clamped", "Cuts what an interpolation gives to the nodes that enclose the place.",
                          "", "thesis eq. 3.8", ""});
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

/// All curves, the exact ones dashed over the others, and dots at the cells where they lie apart.
void draw_curves(const Theme& theme, const Canvas& canvas, const SliceLab& lab,
                 const std::vector<Drawn>& all) {
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
        const ImU32 colour = lab.compares_interpolations ? theme.palette.text : all[k].colour;
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

void slice_plot(PanelContext& context, SliceLab& lab, const std::vector<Drawn>& all, float height) {
    const Theme& theme = context.theme;
    const Grid& grid = context.snapshot().grid();
    const bool flat = grid.dimensions() == 1;
    const std::string title = shown_quantity(context) + (flat ? "" : " along the line");
    std::vector<LegendEntry> legend;
    std::vector<ValueRow> rows;
    Extent extent;
    for (const Drawn& one : all) {
        if (!lab.compares_interpolations || one.exact) legend.push_back({one.label, one.colour});
        extent.add(one.curve.y);
        extent.add(one.cells.y);
    }
    Plot plot;
    plot.title = title;
    plot.unit = context.fields.view().unit;
    plot.x_name = flat ? "x" : "distance";
    plot.size = {0, height};
    const double length = place_line(lab.line, grid).length();
    const Canvas canvas(theme, plot, legend, {0, length}, extent.fitted());
    context.log.control("slice-plot");
    lab.pointed_in_plot.reset();
    if (!canvas) return;
    draw_curves(theme, canvas, lab, all);
    if (lab.pointed_on_field) draw_pointed(theme, canvas, all, *lab.pointed_on_field * length);
    if (!canvas.hovered()) return;
    const double x = canvas.pointer_x();
    lab.pointed_in_plot = x / length;
    draw_pointed(theme, canvas, all, x);
    for (const Drawn& one : all) rows.push_back({one.label, one.colour, value_at(one.curve, x)});
    canvas.values(x, rows);
}

}  // namespace

void draw_slice_window(PanelContext& context) {
    SliceLab& lab = context.view.labs.slice;
    line_controls(context, lab);
    if (lab.compares_interpolations) interpolation_controls(context, lab);
    std::vector<Drawn> all;
    if (lab.compares_interpolations) {
        add_interpolations(context, lab, all);
    } else {
        add_lanes(context, lab, all);
    }
    add_exact(context, lab, all);
    slice_plot(context, lab, all, std::max(ImGui::GetContentRegionAvail().y, context.theme.px(140)));
}

}  // namespace whorl::app
