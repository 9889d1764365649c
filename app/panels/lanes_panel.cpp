// The lanes: which there are, what they are called, and which of them the controls set.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/lane_changes.h"
#include "app/panels/lane_list.h"
#include "app/panels/list.h"
#include "app/scenes/comparisons.h"
#include "core/base/error.h"

namespace whorl::app {
namespace {

/// Names of lanes that have not been made yet; those of a choice that will be refused may differ in nothing.
LaneNames names_of(const Setup& setup) {
    LaneNames names;
    try {
        names.update(setup);
    } catch (const InputError&) {
        Setup plain{{}, std::vector<LaneSetup>(setup.lanes.size())};
        for (std::size_t k = 0; k < setup.lanes.size(); ++k) plain.lanes[k].name = setup.lanes[k].name;
        names.update(plain);
    }
    return names;
}

class LanesPanel final : public Panel {
  public:
    LanesPanel(Ui& ui, RunControl& run) : ui_(ui), run_(run), list_(ui, run) {}

    void draw() override {
        const Setup& setup = run_.setup();
        LaneNames chosen;
        const bool made = setup == run_.session().setup;
        if (!made) chosen = names_of(setup);
        const LaneNames& names = made ? run_.names() : chosen;
        const bool several = names.size() > 1;
        comparison_list();
        if (several) list_.draw(names);
        buttons();
        if (several) reference_list(names);
        finer_reference();
        if (several) scope(names);
    }

  private:
    /// Other lanes from the start of the run.
    void compare(const Lanes& lanes) {
        const Arrange all{lanes.lanes, std::vector<int>(lanes.lanes.size(), 0), lanes.reference};
        if (run_.arrange(all, 0)) run_.restart();
    }

    void comparison_list() {
        static const std::vector<Lanes> known = [] {
            std::vector<Lanes> lanes;
            for (const Comparison& comparison : comparisons()) lanes.push_back(comparison.lanes());
            return lanes;
        }();
        const Setup& setup = run_.setup();
        const auto current = std::find_if(known.begin(), known.end(),
                                          [&](const Lanes& lanes) { return lanes.lanes == setup.lanes; });
        std::string shown = setup.lanes.size() == 1 ? "One lane" : "Own lanes";
        if (current != known.end()) shown = current->title;
        row_label(ui_.theme, "Compare");
        const float room = ImGui::CalcItemWidth() - 1.4f * ImGui::GetFrameHeight();
        if (ImGui::BeginCombo("##compare", fitted(shown, room).c_str(), ImGuiComboFlags_HeightLargest)) {
            if (ui_.list_item("One lane", "comparison=one", setup.lanes == std::vector<LaneSetup>(1),
                              {"One lane", "The scene alone, from its start.", "", "", ""}))
                compare({.title = {}, .lanes = std::vector<LaneSetup>(1)});
            for (std::size_t k = 0; k < known.size(); ++k) {
                std::string lanes;
                for (const LaneSetup& lane : known[k].lanes) lanes += (lanes.empty() ? "" : ", ") + lane.name;
                if (ui_.list_item(known[k].title.c_str(), "comparison=" + std::string(comparisons()[k].key),
                                  current == known.begin() + static_cast<long>(k),
                                  {known[k].title, lanes, "", "", ""}))
                    compare(known[k]);
            }
            ImGui::EndCombo();
        }
        ui_.explain("comparison",
                    {"Compare",
                     "Simulations side by side, on the same scene and the same hand. Choosing a "
                     "comparison starts the run anew.",
                     "", "", ""});
    }

    bool button(const char* label, const char* key, float width, const TooltipText& help) {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                            ImVec2(ui_.theme.px(2), ImGui::GetStyle().FramePadding.y));
        const bool pressed = ui_.button(label, key, width, help);
        ImGui::PopStyleVar();
        return pressed;
    }

    /// Puts a lane behind the selected one, which goes on with the selected one's fields.
    void add(LaneSetup lane, bool as_reference) {
        const std::size_t at = run_.selected_in_setup();
        Arrange changed = run_.arrangement();
        add_lane(changed, at, std::move(lane), as_reference);
        run_.arrange(std::move(changed), as_reference ? at : at + 1);
    }

    void remove() {
        const std::size_t at = run_.selected_in_setup();
        Arrange changed = run_.arrangement();
        remove_lane(changed, at);
        const std::size_t left = changed.lanes.size();
        run_.arrange(std::move(changed), std::min(at, left - 1));
    }

    void move(int by) {
        Arrange changed = run_.arrangement();
        move_lane(changed, run_.selected_in_setup(), by);
        run_.arrange(std::move(changed));
    }

    void buttons() {
        const std::vector<LaneSetup>& lanes = run_.setup().lanes;
        const std::size_t at = run_.selected_in_setup();
        const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
        const float arrow = ui_.theme.px(30);
        const float wide = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - 2 * arrow - 3 * gap));
        const std::string full =
            lanes.size() == Setup::max_lanes ? "There are six lanes, the most there can be." : "";
        const std::string alone = lanes.size() == 1 ? "There is no other lane." : "";
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, ImGui::GetStyle().ItemSpacing.y));
        if (button(
                "Duplicate", "lane-duplicate", wide,
                {"Duplicate", "Another lane that goes on from the selected one as it is now.", "", "", full}))
            add(copy_of(lanes[at], lanes), false);
        ImGui::SameLine();
        if (button("Remove", "lane-remove", wide, {"Remove", "Takes the selected lane away.", "", "", alone}))
            remove();
        ImGui::SameLine();
        if (button("↑", "lane-up", arrow,
                   {"Up", "Moves the selected lane before the one above.", "", "",
                    at == 0 ? "It is the first." : ""}))
            move(-1);
        ImGui::SameLine();
        if (button("↓", "lane-down", arrow,
                   {"Down", "Moves the selected lane behind the one below.", "", "",
                    at + 1 == lanes.size() ? "It is the last." : ""}))
            move(1);
        ImGui::PopStyleVar();
    }

    void reference_list(const LaneNames& names) {
        const int chosen = run_.setup().reference;
        row_label(ui_.theme, "Reference");
        const float room = ImGui::CalcItemWidth() - 1.4f * ImGui::GetFrameHeight();
        const std::string shown =
            chosen == no_reference ? "None" : names.name(static_cast<std::size_t>(chosen));
        const auto choose = [&](int lane) {
            Arrange changed = run_.arrangement();
            changed.reference = lane;
            run_.arrange(std::move(changed));
        };
        if (ImGui::BeginCombo("##reference", fitted(shown, room).c_str())) {
            if (ui_.list_item("None", "reference=none", chosen == no_reference,
                              {"None",
                               "Differences are from the first lane. Errors are against the exact solution, "
                               "where one is known.",
                               "", "", ""}))
                choose(no_reference);
            for (std::size_t k = 0; k < names.size(); ++k) {
                const std::string id = names.name(k) + "##" + std::to_string(k);
                const std::string key = "reference=" + std::to_string(k + 1);
                if (ui_.list_item(id.c_str(), key, chosen == static_cast<int>(k),
                                  {names.name(k), "The others are measured against this lane.", "", "", ""}))
                    choose(static_cast<int>(k));
            }
            ImGui::EndCombo();
        }
        ui_.explain("reference",
                    {"Reference",
                     "The lane that differences and errors of the others are taken from, averaged "
                     "to their cells. Where an exact solution is known, errors are against that.",
                     "", "", ""});
    }

    void finer_reference() {
        const std::vector<LaneSetup>& lanes = run_.setup().lanes;
        const std::string full =
            lanes.size() == Setup::max_lanes ? "There are six lanes, the most there can be." : "";
        row_label(ui_.theme, "Add finer");
        const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
        const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * gap) / 3);
        for (const int times : Setup::refinements) {
            if (times == 1) continue;
            if (times > 2) ImGui::SameLine(0, gap);
            const std::string label = "× " + std::to_string(times);
            const std::string key = "refine=" + std::to_string(times);
            const std::string what =
                "The selected lane's schemes at " + std::to_string(times) + " times the resolution and 1/" +
                std::to_string(times) +
                " of Δt, as the reference. It goes on from the selected lane as it is now; Reset "
                "lets both begin anew.";
            if (!button(label.c_str(), key.c_str(), width, {"Finer reference", what, "", "", full})) continue;
            LaneSetup lane = lanes[run_.selected_in_setup()];
            lane.refine = times;
            lane.name = "Reference × " + std::to_string(times);
            add(copy_of(lane, lanes), true);
        }
    }

    void scope(const LaneNames& names) {
        row_label(ui_.theme, "Controls set");
        const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
        const float width = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
        const bool only = run_.lane_only();
        if (ui_.chip("All lanes", "scope=all", !only, width,
                     {"All lanes",
                      "The controls below set the scene that all lanes share. A lane's own values, "
                      "marked with its colour, stay.",
                      "", "", ""}))
            run_.set_lane_only(false);
        ImGui::SameLine(0, gap);
        const std::string what =
            "The controls below set values of " + names.name(run_.selected_in_setup()) +
            " alone. Right-click a control that is marked to go back to the value of all.";
        if (ui_.chip("This lane", "scope=lane", only, width, {"This lane", what, "", "", ""}))
            run_.set_lane_only(true);
    }

    Ui& ui_;
    RunControl& run_;
    LaneList list_;
};

}  // namespace

const PanelEntry lanes_panel{
    .key = "lanes", .title = "Lanes", .make = [](const Services& s) -> std::unique_ptr<Panel> {
        return std::make_unique<LanesPanel>(s.ui, s.run);
    }};

}  // namespace whorl::app
