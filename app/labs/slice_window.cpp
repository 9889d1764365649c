#include "app/labs/slice_window.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/labs/canvas.h"
#include "app/labs/lab_widgets.h"
#include "app/panels/field_header.h"
#include "app/panels/widgets.h"

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
int samples_per_cell(int cells) {
    return std::clamp(1200 / cells, 2, 24);
}

Drawn drawn(const PanelContext& context, SliceLab& lab, std::size_t lane, const SchemeSet& schemes) {
    const Snapshot& snapshot = context.remote.session().lanes[lane];
    const Field& field = *context.fields.of(lane);
    const Field& filled = lab.fields.of(lane, snapshot, field, context.fields.version());
    Drawn made;
    made.curve =
        curve_along(filled, snapshot, lab.line, schemes, samples_per_cell(lab.line.count(snapshot.grid)));
    made.cells = cells_along(field, snapshot, lab.line);
    return made;
}

/// Every lane by its own interpolation.
void add_lanes(const PanelContext& context, SliceLab& lab, std::vector<Drawn>& all) {
    for (std::size_t k = 0; k < context.names.size(); ++k) {
        if (context.fields.of(k) == nullptr) continue;
        const Scene& scene = context.remote.session().lanes[k].scene;
        all.push_back(drawn(context, lab, k, scene.scalars));
        const bool several = context.names.size() > 1;
        all.back().label =
            several ? std::string_view(context.names.name(k)) : scene.scalars.interpolation.info().label;
        all.back().colour = context.theme.lane(static_cast<int>(k));
    }
}

/// The selected lane by every interpolation that is shown.
void add_interpolations(const PanelContext& context, SliceLab& lab, std::vector<Drawn>& all) {
    const std::size_t lane = context.remote.selected();
    if (context.fields.of(lane) == nullptr) return;
    for (std::size_t k = 0; k < lab.shown.size(); ++k) {
        if (!lab.shown[k]) continue;
        SchemeSet schemes = context.remote.session().lanes[lane].scene.scalars;
        schemes.interpolation = Interpolations::Id::at(k);
        schemes.clamped = lab.clamped;
        all.push_back(drawn(context, lab, lane, schemes));
        if (all.size() > 1) all.back().cells = {};
        all.back().label = Interpolations::infos[k].label;
        all.back().colour = interpolation_colour(context.theme, k);
    }
}

void line_controls(PanelContext& context, SliceLab& lab) {
    const Theme& theme = context.theme;
    const Grid& grid = context.snapshot().grid;
    const bool flat = grid.dimensions() == 1;
    if (flat) lab.line.vertical = false;
    const float width = chip_width(4);
    ImGui::BeginDisabled(flat);
    for (const bool vertical : {false, true}) {
        const char* warning = flat ? "A one-dimensional run has one row." : "";
        if (lab_chip(context, vertical ? "slice=vertical" : "slice=horizontal",
                     {vertical ? "Vertical" : "Horizontal", "A column or a row of cells to look along.", "",
                      "", warning},
                     lab.line.vertical == vertical, std::floor(0.7f * width), !vertical))
            lab.line.vertical = vertical;
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    text(theme.palette.text_dim, lab.line.vertical ? "at x" : "at y");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(std::floor(0.9f * width));
    const double most = lab.line.vertical ? grid.width() : grid.height();
    double at = lab.line.place * most;
    if (slider(theme, "##slice-place", at, {0, most}, "", "%.2f"))
        lab.line.place = std::clamp(at / most, 0.0, 1.0);
    context.trace.control("slice-place");
    context.help.item(theme, "slice-place",
                      {"Where the line lies", "Every lane shows the cells that hold it, at their centres.",
                       "length units", "", ""});
    ImGui::EndDisabled();
    ImGui::SameLine();
    const float half =
        std::floor(0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x));
    if (lab_chip(context, "slice=lanes",
                 {"Lanes", "Every lane in its colour, by its own interpolation.", "", "", ""},
                 !lab.compares_interpolations, half, true))
        lab.compares_interpolations = false;
    if (lab_chip(context, "slice=interpolations",
                 {"Interpolations", "The selected lane's cells by every interpolation chosen below.", "",
                  "thesis sec. 3.1, app. A", ""},
                 lab.compares_interpolations, half, false))
        lab.compares_interpolations = true;
}

void interpolation_controls(PanelContext& context, SliceLab& lab) {
    constexpr int columns = 4;
    const float width = chip_width(columns);
    for (std::size_t k = 0; k < lab.shown.size(); ++k) {
        const SchemeInfo& info = Interpolations::infos[k];
        if (k % columns != 0) ImGui::SameLine(0, std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x));
        if (legend_toggle(context, "slice-scheme=" + std::string(info.key), info,
                          interpolation_colour(context.theme, k), lab.shown[k], width))
            lab.shown[k] = !lab.shown[k];
    }
    if (check("Clamped", lab.clamped)) lab.clamped = !lab.clamped;
    context.trace.control("slice-clamped");
    context.help.item(context.theme, "slice-clamped",
                      {"Clamped", "Cuts what an interpolation gives to the nodes that enclose the place.", "",
                       "thesis eq. 3.8", ""});
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

void slice_plot(PanelContext& context, const SliceLab& lab, const std::vector<Drawn>& all, float height) {
    const Theme& theme = context.theme;
    const Grid& grid = context.snapshot().grid;
    std::string title = shown_quantity(context);
    char where[48];
    const double across = (lab.line.index(grid) + 0.5) * grid.h;
    std::snprintf(where, sizeof where, " at %s = %.4g", lab.line.vertical ? "x" : "y", across);
    if (grid.dimensions() == 2) title += where;
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
    plot.x_name = lab.line.vertical ? "y" : "x";
    plot.size = {0, height};
    const double length = lab.line.vertical ? grid.height() : grid.width();
    const Canvas canvas(theme, plot, legend, {0, length}, extent.fitted());
    context.trace.control("slice-plot");
    if (!canvas) return;
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
        // Where they lie apart.
        if (cells.x.size() < 2 || canvas.frame().to_x(static_cast<double>(cells.x[1])) -
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
    if (!canvas.hovered()) return;
    const double x = canvas.pointer_x();
    draw_hairline(*ImGui::GetWindowDrawList(), theme, canvas.frame(), x);
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
    const Snapshot& selected = context.snapshot();
    if (selected.has_exact && &context.fields.view() == &views().front() && !context.fields.difference())
        all.push_back(
            {"exact", context.theme.palette.text, cells_along(selected.exact, selected, lab.line), {}, true});
    slice_plot(context, lab, all, std::max(ImGui::GetContentRegionAvail().y, context.theme.px(140)));
}

void draw_slice_line(const PanelContext& context, const FieldPlacement& place, ImDrawList& list) {
    const SliceLab& lab = context.view.labs.slice;
    if (!lab.open) return;
    const Theme& theme = context.theme;
    for (const FieldTile& tile : place.tiles) {
        const Grid& grid = context.remote.session().lanes[tile.lane].grid;
        const double at = (lab.line.index(grid) + 0.5) * grid.h;
        const glm::dvec2 from = place.pixel(tile, lab.line.vertical ? WorldPoint{at, 0} : WorldPoint{0, at});
        const glm::dvec2 to =
            place.pixel(tile, lab.line.vertical ? WorldPoint{at, tile.height} : WorldPoint{tile.width, at});
        const ImVec2 low{static_cast<float>(from.x), static_cast<float>(from.y)};
        const ImVec2 high{static_cast<float>(to.x), static_cast<float>(to.y)};
        list.PushClipRect({static_cast<float>(tile.part.x), static_cast<float>(tile.part.y)},
                          {static_cast<float>(tile.part.x + tile.part.width),
                           static_cast<float>(tile.part.y + tile.part.height)},
                          true);
        list.AddLine(low, high, IM_COL32(0, 0, 0, 140), theme.px(3));
        list.AddLine(low, high, faded(theme.palette.text, 0.8f), theme.px(1));
        list.PopClipRect();
    }
}

}  // namespace whorl::app
