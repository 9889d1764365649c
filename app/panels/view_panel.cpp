// What of the run is on screen, and in which colours.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/list.h"
#include "app/run/run_control.h"
#include "app/run/view_settings.h"
#include "app/ui/ui.h"
#include "core/experiments/experiment.h"

namespace whorl::app {
namespace {

class ViewPanel final : public Panel {
  public:
    ViewPanel(Ui& ui, const RunView& run, ViewSettings& view) : ui_(ui), run_(run), view_(view) {}

    void draw() override {
        view_chips();
        map_list();
        range();
        const float left = ImGui::GetCursorPosX();
        const float half = 0.5f * ImGui::GetContentRegionAvail().x;
        if (ui_.check("Crisp pixels", "crisp", view_.crisp,
                      {"Crisp pixels", "Squares of one value each; otherwise smooth between the cells.", "",
                       "", ""}))
            view_.crisp = !view_.crisp;
        ImGui::SameLine(left + half);
        if (ui_.check("Arrows", "arrows", view_.arrows,
                      {"Arrows", "The velocity, over the field.", "", "", ""}))
            view_.arrows = !view_.arrows;
        const bool looked_at = view_.shown->of_limiters;
        if (ui_.check(
                "Count limited nodes", "count-limited", view_.count_limited || looked_at,
                {"Count limited nodes",
                 "A plot of how many nodes a limiter or a clamped interpolation changed in each step. Costs "
                 "two to seven more advections in every step.",
                 "", "thesis sec. 3.2", looked_at ? "The chosen view counts them already." : ""}))
            view_.count_limited = !view_.count_limited;
    }

  private:
    void view_chips() {
        const int columns = ImGui::GetContentRegionAvail().x > ui_.theme.px(290) ? 3 : 2;
        const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
        const float width =
            std::floor((ImGui::GetContentRegionAvail().x - static_cast<float>(columns - 1) * gap) /
                       static_cast<float>(columns));
        int k = 0;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
        for (const View* each : views()) {
            const View& view = *each;
            const bool known = available(view, run_.snapshot());
            if (!known && experiment(run_.scene().experiment).exact == nullptr) continue;
            if (k++ % columns != 0) ImGui::SameLine();
            const std::string label = fitted(view.label, width) + "##" + std::string(view.key);
            if (ui_.chip(label.c_str(), "view=" + std::string(view.key), view_.shown == &view, width,
                         {view.label, view.help, view.unit, "",
                          known ? "" : "The exact solution is not known at this time."}))
                view_.shown = &view;
        }
        ImGui::PopStyleVar();
    }

    void map_list() {
        row_label(ui_.theme, "Colours");
        const ColourMap& chosen = view_.map();
        if (ImGui::BeginCombo("##map", std::string(chosen.label).c_str())) {
            for (const ColourMap& map : colour_maps()) {
                if (map.kind != chosen.kind) continue;
                const std::string key = "map=" + std::string(map.key);
                if (ui_.list_item(std::string(map.label).c_str(), key, map.key == chosen.key,
                                  {map.label,
                                   map.kind == ColourMap::Kind::Diverging
                                       ? "From one hue over the neutral value to another."
                                       : "From the least value to the greatest.",
                                   "", "", ""})) {
                    view_.choose(map);
                }
            }
            ImGui::EndCombo();
        }
        ui_.explain("map",
                    {"Colours", "Diverging maps for what has a neutral value, sequential ones otherwise.", "",
                     "", ""});
    }

    void range() {
        ColourRange& range = view_.range;
        if (ui_.check("Hold the range", "hold-range", range.held(),
                      {"Hold the range", "Otherwise the colour bar follows the least and greatest value.", "",
                       "", ""}))
            range.hold(!range.held());
        row_label(ui_.theme, "Range");
        ImGui::BeginDisabled(!range.held());
        float ends[2] = {range.ends().lo, range.ends().hi};
        const float speed = std::max(1e-6f, 0.005f * (ends[1] - ends[0]));
        if (ImGui::DragFloat2("##range", ends, speed, 0, 0, "%.4g")) range.set({ends[0], ends[1]});
        ImGui::EndDisabled();
        ui_.tooltip.item(ui_.theme, "range",
                         {"Range", "Values at the ends of the colour bar.", "Drag, or Ctrl+click to type", "",
                          range.held() ? "" : "The range follows the field; hold it to set it."});
    }

    Ui& ui_;
    const RunView& run_;
    ViewSettings& view_;
};

}  // namespace

const PanelEntry view_panel{
    .key = "view", .title = "View", .make = [](const Services& s) -> std::unique_ptr<Panel> {
        return std::make_unique<ViewPanel>(s.ui, s.run, s.view);
    }};

}  // namespace whorl::app
