// The lanes: which there are, what they are called, and which of them the controls set.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/panel.h"
#include "app/render/text.h"
#include "app/scenes/comparisons.h"
#include "app/ui/widgets.h"
#include "core/base/error.h"

namespace whorl::app {
namespace {

using LaneList = std::vector<LaneSetup>;

/// Names of lanes that have not been made yet; those of a choice that will be refused may differ in nothing.
LaneNames names_of(const Setup& setup) {
    LaneNames names;
    try {
        names.update(setup);
    } catch (const InputError&) {
        Setup plain{{}, LaneList(setup.lanes.size())};
        for (std::size_t k = 0; k < setup.lanes.size(); ++k) plain.lanes[k].name = setup.lanes[k].name;
        names.update(plain);
    }
    return names;
}

// ---- comparisons

/// Other lanes from the start of the run.
void compare(PanelContext& context, const Lanes& lanes) {
    const Arrange all{lanes.lanes, std::vector<int>(lanes.lanes.size(), 0), lanes.reference};
    if (context.client.arrange(all, 0)) context.client.restart();
}

void comparison_list(PanelContext& context) {
    static const std::vector<Lanes> known = [] {
        std::vector<Lanes> lanes;
        for (const Comparison& comparison : comparisons()) lanes.push_back(comparison.lanes());
        return lanes;
    }();
    const Setup& setup = context.client.setup();
    const auto current = std::find_if(known.begin(), known.end(),
                                      [&](const Lanes& lanes) { return lanes.lanes == setup.lanes; });
    std::string shown = setup.lanes.size() == 1 ? "One lane" : "Own lanes";
    if (current != known.end()) shown = current->title;
    row_label(context.theme, "Compare");
    const float room = ImGui::CalcItemWidth() - 1.4f * ImGui::GetFrameHeight();
    if (ImGui::BeginCombo("##compare", fitted(shown, room).c_str(), ImGuiComboFlags_HeightLargest)) {
        if (list_item("One lane", setup.lanes == LaneList(1)))
            compare(context, {.title = {}, .lanes = LaneList(1)});
        context.log.control("comparison=one");
        context.tooltip.item(context.theme, "comparison=one",
                             {"One lane", "The scene alone, from its start.", "", "", ""});
        for (std::size_t k = 0; k < known.size(); ++k) {
            if (list_item(known[k].title.c_str(), current == known.begin() + static_cast<long>(k)))
                compare(context, known[k]);
            const std::string key = "comparison=" + std::string(comparisons()[k].key);
            context.log.control(key);
            std::string lanes;
            for (const LaneSetup& lane : known[k].lanes) lanes += (lanes.empty() ? "" : ", ") + lane.name;
            context.tooltip.item(context.theme, key, {known[k].title, lanes, "", "", ""});
        }
        ImGui::EndCombo();
    }
    context.log.control("comparison");
    context.tooltip.item(context.theme, "comparison",
                         {"Compare",
                          "Simulations side by side, on the same scene and the same hand. Choosing a "
                          "comparison starts the run anew.",
                          "", "", ""});
}

// ---- the list

Renaming renaming(int id, const std::string& name) {
    Renaming now{.id = id};
    const std::size_t length = std::min(name.size(), sizeof now.text - 1);
    std::copy_n(name.begin(), length, now.text);
    return now;
}

void name_field(PanelContext& context, std::size_t lane) {
    Renaming& now = context.view.renaming;
    if (!now.begun) ImGui::SetKeyboardFocusHere();
    now.begun = true;
    ImGui::SetNextItemWidth(-FLT_MIN);
    const bool done =
        ImGui::InputText("##name", now.text, sizeof now.text,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    context.log.control("lane-name");
    context.tooltip.item(
        context.theme, "lane-name",
        {"Name", "Enter takes it. Without a name, a lane is called by what differs.", "", "", ""});
    if (!done && !ImGui::IsItemDeactivated()) return;
    if (done || ImGui::IsItemDeactivatedAfterEdit()) {
        Arrange changed = context.client.arrangement();
        changed.lanes[lane].name = now.text;
        if (changed.lanes != context.client.setup().lanes) context.client.arrange(std::move(changed));
    }
    now = {};
}

void lane_row(PanelContext& context, std::size_t lane, const std::string& name, const std::string& differs) {
    const Theme& theme = context.theme;
    const SessionClient& client = context.client;
    const bool selected = lane == client.selected_in_setup();
    const std::string key = "lane=" + std::to_string(lane + 1);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton(key.c_str(), {width, height})) context.client.select_id(client.ids()[lane]);
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && ImGui::IsMouseDoubleClicked(0)) context.view.renaming = renaming(client.ids()[lane], name);
    context.log.control(key);
    const bool reference = static_cast<int>(lane) == client.setup().reference;
    context.tooltip.item(theme, key,
                         {name, said_of(differs), "Click to select, double-click to rename", "",
                          reference ? "The reference lane: the others are measured against it." : ""});

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{corner.x + width, corner.y + height};
    if (selected || hovered)
        list.AddRectFilled(corner, end, ImGui::GetColorU32(selected ? ImGuiCol_Button : ImGuiCol_FrameBg),
                           theme.px(4));
    const float swatch = theme.px(10);
    const float middle = std::floor(corner.y + 0.5f * (height - swatch));
    float x = corner.x + theme.px(8);
    list.AddRectFilled({x, middle}, {x + swatch, middle + swatch}, theme.lane(static_cast<int>(lane)),
                       theme.px(2));
    x += swatch + theme.px(8);
    float right = end.x - theme.px(8);
    const float top = corner.y + 0.5f * (height - theme.body->FontSize);
    const float small_top = top + theme.body->Ascent - theme.small->Ascent;
    if (reference) {
        right -= text_width(*theme.small, "reference");
        add_text(list, *theme.small, {right, small_top}, theme.palette.accent, "reference");
        right -= theme.px(8);
    }
    const ImFont& font = selected ? *theme.bold : *theme.body;
    const std::string shown = fitted(font, name, right - x);
    add_text(list, font, {x, top}, theme.palette.text, shown);
    x += text_width(font, shown) + theme.px(8);
    if (right - x > theme.px(30))
        add_text(list, *theme.small, {x, small_top}, theme.palette.text_dim,
                 fitted(*theme.small, differs, right - x));
}

void lane_list(PanelContext& context, const LaneNames& names) {
    const Setup& setup = context.client.setup();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        ImVec2(ImGui::GetStyle().ItemSpacing.x, context.theme.px(2)));
    for (std::size_t k = 0; k < setup.lanes.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        const int id = context.client.ids()[k];
        if (id != SessionClient::unknown && id == context.view.renaming.id) {
            name_field(context, k);
        } else {
            lane_row(context, k, names.name(k), names.difference(k));
        }
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    ImGui::Dummy({0, context.theme.px(1)});
}

// ---- what can be done to them

bool button(PanelContext& context, const char* label, const char* key, float width, const TooltipText& help) {
    ImGui::BeginDisabled(!help.warning.empty());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(context.theme.px(2), ImGui::GetStyle().FramePadding.y));
    const bool pressed = ImGui::Button(label, {width, 0});
    ImGui::PopStyleVar();
    ImGui::EndDisabled();
    context.log.control(key);
    context.tooltip.item(context.theme, key, help);
    return pressed;
}

/// Puts a lane behind the selected one, which goes on with the selected one's fields.
void add(PanelContext& context, LaneSetup lane, bool as_reference) {
    const std::size_t at = context.client.selected_in_setup();
    const auto next = static_cast<std::ptrdiff_t>(at) + 1;
    Arrange changed = context.client.arrangement();
    changed.lanes.insert(changed.lanes.begin() + next, std::move(lane));
    changed.from.insert(changed.from.begin() + next, static_cast<int>(at));
    if (as_reference) {
        changed.reference = static_cast<int>(at) + 1;
    } else if (changed.reference > static_cast<int>(at)) {
        ++changed.reference;
    }
    context.client.arrange(std::move(changed), as_reference ? at : at + 1);
}

void remove(PanelContext& context) {
    const std::size_t at = context.client.selected_in_setup();
    Arrange changed = context.client.arrangement();
    changed.lanes.erase(changed.lanes.begin() + static_cast<std::ptrdiff_t>(at));
    changed.from.erase(changed.from.begin() + static_cast<std::ptrdiff_t>(at));
    const std::size_t left = changed.lanes.size();
    if (changed.reference == static_cast<int>(at)) changed.reference = no_reference;
    if (changed.reference > static_cast<int>(at)) --changed.reference;
    context.client.arrange(std::move(changed), std::min(at, left - 1));
}

void move(PanelContext& context, int by) {
    const auto at = static_cast<int>(context.client.selected_in_setup());
    const int to = at + by;
    Arrange changed = context.client.arrangement();
    std::swap(changed.lanes[static_cast<std::size_t>(at)], changed.lanes[static_cast<std::size_t>(to)]);
    std::swap(changed.from[static_cast<std::size_t>(at)], changed.from[static_cast<std::size_t>(to)]);
    if (changed.reference == at) {
        changed.reference = to;
    } else if (changed.reference == to) {
        changed.reference = at;
    }
    context.client.arrange(std::move(changed));
}

LaneSetup copy_of(const LaneSetup& lane, const LaneList& lanes) {
    LaneSetup copy = lane;
    if (copy.name.empty()) return copy;
    const auto taken = [&](const std::string& name) {
        return std::any_of(lanes.begin(), lanes.end(), [&](const LaneSetup& l) { return l.name == name; });
    };
    for (int number = 2; taken(copy.name); ++number)
        copy.name = lane.name + " (" + std::to_string(number) + ")";
    return copy;
}

void buttons(PanelContext& context) {
    const LaneList& lanes = context.client.setup().lanes;
    const std::size_t at = context.client.selected_in_setup();
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    const float arrow = context.theme.px(30);
    const float wide = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - 2 * arrow - 3 * gap));
    const std::string full =
        lanes.size() == Setup::max_lanes ? "There are six lanes, the most there can be." : "";
    const std::string alone = lanes.size() == 1 ? "There is no other lane." : "";
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, ImGui::GetStyle().ItemSpacing.y));
    if (button(context, "Duplicate", "lane-duplicate", wide,
               {"Duplicate", "Another lane that goes on from the selected one as it is now.", "", "", full}))
        add(context, copy_of(lanes[at], lanes), false);
    ImGui::SameLine();
    if (button(context, "Remove", "lane-remove", wide,
               {"Remove", "Takes the selected lane away.", "", "", alone}))
        remove(context);
    ImGui::SameLine();
    if (button(context, "↑", "lane-up", arrow,
               {"Up", "Moves the selected lane before the one above.", "", "",
                at == 0 ? "It is the first." : ""}))
        move(context, -1);
    ImGui::SameLine();
    if (button(context, "↓", "lane-down", arrow,
               {"Down", "Moves the selected lane behind the one below.", "", "",
                at + 1 == lanes.size() ? "It is the last." : ""}))
        move(context, 1);
    ImGui::PopStyleVar();
}

void reference_list(PanelContext& context, const LaneNames& names) {
    const int chosen = context.client.setup().reference;
    row_label(context.theme, "Reference");
    const float room = ImGui::CalcItemWidth() - 1.4f * ImGui::GetFrameHeight();
    const std::string shown = chosen == no_reference ? "None" : names.name(static_cast<std::size_t>(chosen));
    const auto choose = [&](int lane) {
        Arrange changed = context.client.arrangement();
        changed.reference = lane;
        context.client.arrange(std::move(changed));
    };
    if (ImGui::BeginCombo("##reference", fitted(shown, room).c_str())) {
        if (list_item("None", chosen == no_reference)) choose(no_reference);
        context.log.control("reference=none");
        context.tooltip.item(context.theme, "reference=none",
                             {"None",
                              "Differences are from the first lane. Errors are against the exact solution, "
                              "where one is known.",
                              "", "", ""});
        for (std::size_t k = 0; k < names.size(); ++k) {
            const std::string id = names.name(k) + "##" + std::to_string(k);
            if (list_item(id.c_str(), chosen == static_cast<int>(k))) choose(static_cast<int>(k));
            const std::string key = "reference=" + std::to_string(k + 1);
            context.log.control(key);
            context.tooltip.item(context.theme, key,
                                 {names.name(k), "The others are measured against this lane.", "", "", ""});
        }
        ImGui::EndCombo();
    }
    context.log.control("reference");
    context.tooltip.item(context.theme, "reference",
                         {"Reference",
                          "The lane that differences and errors of the others are taken from, averaged "
                          "to their cells. Where an exact solution is known, errors are against that.",
                          "", "", ""});
}

void finer_reference(PanelContext& context) {
    const LaneList& lanes = context.client.setup().lanes;
    const std::string full =
        lanes.size() == Setup::max_lanes ? "There are six lanes, the most there can be." : "";
    row_label(context.theme, "Add finer");
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
        if (!button(context, label.c_str(), key.c_str(), width, {"Finer reference", what, "", "", full}))
            continue;
        LaneSetup lane = lanes[context.client.selected_in_setup()];
        lane.refine = times;
        lane.name = "Reference × " + std::to_string(times);
        add(context, copy_of(lane, lanes), true);
    }
}

void scope(PanelContext& context, const LaneNames& names) {
    row_label(context.theme, "Controls set");
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    const float width = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
    const bool only = context.client.lane_only();
    if (chip(context.theme, "All lanes", !only, width)) context.client.set_lane_only(false);
    context.log.control("scope=all");
    context.tooltip.item(context.theme, "scope=all",
                         {"All lanes",
                          "The controls below set the scene that all lanes share. A lane's own values, "
                          "marked with its colour, stay.",
                          "", "", ""});
    ImGui::SameLine(0, gap);
    if (chip(context.theme, "This lane", only, width)) context.client.set_lane_only(true);
    context.log.control("scope=lane");
    const std::string what = "The controls below set values of " +
                             names.name(context.client.selected_in_setup()) +
                             " alone. Right-click a control that is marked to go back to the value of all.";
    context.tooltip.item(context.theme, "scope=lane", {"This lane", what, "", "", ""});
}

}  // namespace

void draw_lanes_panel(PanelContext& context) {
    const Setup& setup = context.client.setup();
    LaneNames chosen;
    const bool made = setup == context.client.session().setup;
    if (!made) chosen = names_of(setup);
    const LaneNames& names = made ? context.names : chosen;
    const bool several = names.size() > 1;
    comparison_list(context);
    if (several) lane_list(context, names);
    buttons(context);
    if (several) reference_list(context, names);
    finer_reference(context);
    if (several) scope(context, names);
}

}  // namespace whorl::app
