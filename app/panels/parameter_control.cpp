#include "app/panels/parameter_control.h"

#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "app/panels/applicability.h"
#include "app/ui/widgets.h"
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
    line += "--set " + p.key + "=" + (p.kind == Kind::Truth ? "true" : "…");
    if (p.kind == Kind::Number || p.kind == Kind::Integer) line += " · Ctrl+click to type";
    return line;
}

/// The lanes that have a value of their own, where the controls do not set one of these alone.
std::vector<std::size_t> overriding(const SessionClient& client, const Parameter& p) {
    std::vector<std::size_t> lanes;
    const std::size_t selected = client.selected_in_setup();
    for (std::size_t k = 0; k < client.setup().lanes.size(); ++k) {
        if ((!client.lane_only() || k == selected) && client.overridden(p, k)) lanes.push_back(k);
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

std::string overrides_help(const SessionClient& client, const std::vector<std::size_t>& lanes) {
    if (lanes.empty()) return {};
    if (client.lane_only()) return "This lane's own value. Right-click to go back to the value of all lanes.";
    const std::string who = lanes.size() == client.setup().lanes.size() ? "All lanes have values"
                            : lanes.size() == 1                         ? "A lane has a value"
                                                : std::to_string(lanes.size()) + " lanes have values";
    return who + " of their own, which this does not change. Right-click to give them the value of all.";
}

void help(PanelContext& context, const Parameter& p, const std::string& idle) {
    const std::string last_line = detail(p);
    std::string what = p.help;
    std::string source = p.source;
    if (p.kind == Kind::Choice) {
        const SchemeInfo& chosen = p.choices[static_cast<std::size_t>(p.get(context.scene()))];
        what += "\n" + std::string(chosen.label) + ": " + std::string(chosen.help);
    }
    context.tooltip.item(context.theme, p.key, {p.label, what, last_line, source, idle});
}

void choice(PanelContext& context, const Parameter& p, const char* id) {
    const auto chosen = static_cast<std::size_t>(p.get(context.scene()));
    const float room = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - ImGui::GetStyle().FramePadding.x;
    const std::string shown = fitted(p.choices[chosen].label, room);
    if (!ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLargest)) return;
    for (std::size_t k = 0; k < p.choices.size(); ++k) {
        const SchemeInfo& info = p.choices[k];
        const std::string label(info.label);
        if (list_item(label.c_str(), k == chosen) && k != chosen) {
            context.client.set(p, static_cast<double>(k));
        }
        const std::string key = p.key + "=" + std::string(info.key);
        context.log.control(key);
        context.tooltip.item(context.theme, key, {info.label, info.help, "", info.source, ""});
    }
    ImGui::EndCombo();
}

/// Numbers that rebuild the domain are sent when the slider is let go, others as it moves.
void number(PanelContext& context, const Parameter& p, const char* id) {
    const bool on_release = p.group == Parameter::Group::Domain;
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID dragged = ImGui::GetID((p.key + " dragged").c_str());
    double value = p.get(context.scene());
    float& held = *storage.GetFloatRef(dragged, std::nanf(""));
    if (on_release && !std::isnan(held)) value = static_cast<double>(held);
    const SliderRange range{p.slider_min, p.slider_max, p.logarithmic};
    bool changed = false;
    if (p.kind == Kind::Integer) {
        int whole = static_cast<int>(value);
        changed = slider(context.theme, id, whole, range, p.unit);
        if (changed) value = whole;
    } else {
        changed = slider(context.theme, id, value, range, p.unit, number_format(p).c_str());
    }
    if (!on_release) {
        if (changed) context.client.set(p, value);
        return;
    }
    if (changed) held = static_cast<float>(value);
    if (ImGui::IsItemDeactivated()) {
        if (!std::isnan(held)) context.client.set(p, value);
        held = std::nanf("");
    }
}

/// The control itself, at the cursor and the next item's width.
void control(PanelContext& context, const Parameter& p) {
    const std::string idle = why_idle(p, context.scene());
    const std::string id = "##" + p.key;
    ImGui::BeginDisabled(!idle.empty());
    if (p.kind == Kind::Truth) {
        const bool value = p.get(context.scene()) != 0;
        const ImGuiStyle& style = ImGui::GetStyle();
        const float room = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - style.ItemInnerSpacing.x;
        if (check((fitted(p.label, room) + id).c_str(), value)) context.client.set(p, value ? 0 : 1);
    } else if (p.kind == Kind::Choice) {
        choice(context, p, id.c_str());
    } else {
        number(context, p, id.c_str());
    }
    ImGui::EndDisabled();
    context.log.control(p.key);
    const std::vector<std::size_t> own = overriding(context.client, p);
    if (!own.empty()) {
        mark(context.theme, own);
        const bool clicked =
            ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && ImGui::IsMouseClicked(1);
        if (clicked) context.client.drop_overrides(p);
    }
    const std::string overrides = overrides_help(context.client, own);
    help(context, p, idle + (idle.empty() || own.empty() ? "" : "\n") + overrides);
}

const Parameter* find(const std::string& key) {
    for (const Parameter& p : parameters()) {
        if (p.key == key) return &p;
    }
    return nullptr;
}

/// Two controls side by side under their label.
void pair_row(PanelContext& context, const Parameter& velocity, const Parameter& scalars) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
    const float left = ImGui::GetCursorPosX();
    if (velocity.kind != Kind::Truth) text(context.theme.palette.text_dim, velocity.label);
    ImGui::SetNextItemWidth(half);
    control(context, velocity);
    ImGui::SameLine(left + half + gap);
    ImGui::SetNextItemWidth(half);
    control(context, scalars);
}

}  // namespace

void parameter_row(PanelContext& context, const Parameter& p) {
    if (p.kind != Kind::Truth) row_label(context.theme, p.label);
    ImGui::SetNextItemWidth(-FLT_MIN);
    control(context, p);
}

void parameter_or_pair(PanelContext& context, const Parameter& p) {
    if (p.key == "steps" || p.key.rfind("velocity.", 0) == 0 || p.key.rfind("scalars.", 0) == 0) return;
    const Parameter* velocity = find("velocity." + p.key);
    const Parameter* scalars = find("scalars." + p.key);
    if (velocity != nullptr && scalars != nullptr && !context.scene().linked) {
        pair_row(context, *velocity, *scalars);
    } else {
        parameter_row(context, p);
    }
}

void parameter_rows(PanelContext& context, Parameter::Group group) {
    for (const Parameter& p : parameters()) {
        if (p.group == group) parameter_or_pair(context, p);
    }
}

}  // namespace whorl::app
