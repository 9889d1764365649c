#include "app/panels/parameter_control.h"

#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "app/panels/applicability.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

using Kind = Parameter::Kind;

/// As many decimals as a slider of this range needs to be read by.
std::string number_format(const Parameter& p) {
    if (p.logarithmic && p.slider_min < 1e-4) return "%.1e";
    const double scale = p.logarithmic ? 10 * p.slider_min : p.slider_max - p.slider_min;
    const int decimals = std::clamp(static_cast<int>(std::lround(2.5 - std::log10(scale))), 0, 6);
    return "%." + std::to_string(decimals) + "f";
}

std::string detail(const Parameter& p) {
    std::string line;
    if (p.kind == Kind::Number || p.kind == Kind::Integer) {
        line = figure(p.min) + " to " + figure(p.max) + (p.unit.empty() ? "" : " " + p.unit) + " · ";
    }
    line += "--set " + p.key + "=" + (p.kind == Kind::Switch ? "true" : "…");
    if (p.kind == Kind::Number || p.kind == Kind::Integer) line += " · Ctrl+click to type";
    return line;
}

/// The lanes that have a value of their own, where the controls do not set one of these alone.
std::vector<std::size_t> overriding(const RunView& run, const Parameter& p) {
    std::vector<std::size_t> lanes;
    const std::size_t selected = run.selected_in_setup();
    for (std::size_t k = 0; k < run.setup().lanes.size(); ++k) {
        if ((!run.lane_only() || k == selected) && run.overridden(p, k)) lanes.push_back(k);
    }
    return lanes;
}

/// A stripe in the lanes' colours at the last item's left edge.
void mark(const Theme& theme, const std::vector<std::size_t>& lanes) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const float height = (ImGui::GetItemRectSize().y) / static_cast<float>(lanes.size());
    const float width = theme.px(3);
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        const float top = std::round(low.y + static_cast<float>(k) * height);
        ImGui::GetWindowDrawList()->AddRectFilled({low.x, top}, {low.x + width, std::round(top + height)},
                                                  theme.lane(static_cast<int>(lanes[k])));
    }
}

std::string overrides_help(const RunView& run, const std::vector<std::size_t>& lanes) {
    if (lanes.empty()) return {};
    if (run.lane_only()) return "This lane's own value. Right-click to go back to the value of all lanes.";
    const std::string who = lanes.size() == run.setup().lanes.size() ? "All lanes have values"
                            : lanes.size() == 1                      ? "A lane has a value"
                                                : std::to_string(lanes.size()) + " lanes have values";
    return who + " of their own, which this does not change. Right-click to give them the value of all.";
}

const Parameter* find(const std::string& key) {
    for (const Parameter& p : parameters()) {
        if (p.key == key) return &p;
    }
    return nullptr;
}

}  // namespace

void ParameterControls::rows(Parameter::Group group) {
    for (const Parameter& p : parameters()) {
        if (p.group == group) row_or_pair(p);
    }
}

void ParameterControls::help(const Parameter& p, const std::string& idle) {
    const std::string last_line = detail(p);
    std::string what = p.help;
    std::string source = p.source;
    if (p.kind == Kind::Choice) {
        const SchemeInfo& chosen = p.choices[static_cast<std::size_t>(p.get(run_.scene()))];
        what += "\n" + std::string(chosen.label) + ": " + std::string(chosen.help);
    }
    ui_.tooltip.item(ui_.theme, p.key, {p.label, what, last_line, source, idle});
}

void ParameterControls::choice(const Parameter& p, const char* id) {
    const auto chosen = static_cast<std::size_t>(p.get(run_.scene()));
    const float room = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x;
    const std::string shown = fitted(p.choices[chosen].label, room);
    if (!ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLargest)) return;
    for (std::size_t k = 0; k < p.choices.size(); ++k) {
        const SchemeInfo& info = p.choices[k];
        const std::string label(info.label);
        if (list_item(label.c_str(), k == chosen) && k != chosen) {
            run_.set(p, static_cast<double>(k));
        }
        const std::string key = p.key + "=" + std::string(info.key);
        ui_.explain(key, {info.label, info.help, "", info.source, ""});
    }
    ImGui::EndCombo();
}

void ParameterControls::number(const Parameter& p, const char* id) {
    const bool on_release = p.group == Parameter::Group::Domain;
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID dragged = ImGui::GetID((p.key + " dragged").c_str());
    double value = p.get(run_.scene());
    float& held = *storage.GetFloatRef(dragged, std::nanf(""));
    if (on_release && !std::isnan(held)) value = static_cast<double>(held);
    const SliderRange range{p.slider_min, p.slider_max, p.logarithmic};
    bool changed = false;
    if (p.kind == Kind::Integer) {
        int whole = static_cast<int>(value);
        changed = slider(ui_.theme, id, whole, range, p.unit);
        if (changed) value = whole;
    } else {
        changed = slider(ui_.theme, id, value, range, p.unit, number_format(p).c_str());
    }
    if (!on_release) {
        if (changed) run_.set(p, value);
        return;
    }
    if (changed) held = static_cast<float>(value);
    if (ImGui::IsItemDeactivated()) {
        if (!std::isnan(held)) run_.set(p, value);
        held = std::nanf("");
    }
}

void ParameterControls::control(const Parameter& p) {
    const std::string idle = inactive_reason(p, run_.scene());
    const std::string id = "##" + p.key;
    ImGui::BeginDisabled(!idle.empty());
    if (p.kind == Kind::Switch) {
        const bool value = p.get(run_.scene()) != 0;
        const ImGuiStyle& style = ImGui::GetStyle();
        const float room = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - style.ItemInnerSpacing.x;
        if (check((fitted(p.label, room) + id).c_str(), value)) run_.set(p, value ? 0 : 1);
    } else if (p.kind == Kind::Choice) {
        choice(p, id.c_str());
    } else {
        number(p, id.c_str());
    }
    ImGui::EndDisabled();
    ui_.log.control(p.key);
    const std::vector<std::size_t> own = overriding(run_, p);
    if (!own.empty()) {
        mark(ui_.theme, own);
        const bool clicked =
            ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && ImGui::IsMouseClicked(1);
        if (clicked) run_.drop_overrides(p);
    }
    const std::string overrides = overrides_help(run_, own);
    help(p, idle + (idle.empty() || own.empty() ? "" : "\n") + overrides);
}

void ParameterControls::pair(const Parameter& velocity, const Parameter& scalars) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
    const float left = ImGui::GetCursorPosX();
    if (velocity.kind != Kind::Switch) text(ui_.theme.palette.text_dim, velocity.label);
    ImGui::SetNextItemWidth(half);
    control(velocity);
    ImGui::SameLine(left + half + gap);
    ImGui::SetNextItemWidth(half);
    control(scalars);
}

void ParameterControls::row(const Parameter& p) {
    if (p.kind != Kind::Switch) row_label(ui_.theme, p.label);
    ImGui::SetNextItemWidth(-FLT_MIN);
    control(p);
}

void ParameterControls::row_or_pair(const Parameter& p) {
    if (p.key == "steps" || p.key.rfind("velocity.", 0) == 0 || p.key.rfind("scalars.", 0) == 0) return;
    const Parameter* velocity = find("velocity." + p.key);
    const Parameter* scalars = find("scalars." + p.key);
    if (velocity != nullptr && scalars != nullptr && !run_.scene().linked) {
        pair(*velocity, *scalars);
    } else {
        row(p);
    }
}

}  // namespace whorl::app
