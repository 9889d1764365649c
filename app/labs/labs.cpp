#include "app/labs/labs.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "app/inspector/inspector_window.h"
#include "app/labs/interpolation_lab.h"
#include "app/labs/slice_window.h"
#include "app/labs/stencil_lab.h"

namespace whorl::app {
namespace {

/// A window's place and size, pixels.
struct Bounds {
    ImVec2 low, size;
};

/// Inside the screen, a little off the labs that are open already.
Bounds bounds_of(const PanelContext& context, const LabInfo& lab, int before) {
    using Anchor = LabInfo::Anchor;
    const Theme& theme = context.theme;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = theme.px(8);
    const ImVec2 most{screen.x - 2 * margin, screen.y - 2 * margin};
    if (lab.anchor == Anchor::Side) {
        const LabState::Side& side = context.view.labs.side;
        return {{side.x, margin}, {side.width, most.y}};
    }
    const ImVec2 size{std::min(theme.px(lab.width), most.x), std::min(theme.px(lab.height), most.y)};
    const float down = lab.anchor == Anchor::Bottom ? 1 : 0.5f;
    const float off = theme.px(18) * static_cast<float>(before);
    return {{std::floor(std::clamp(0.5f * (screen.x - size.x) + off, margin, margin + most.x - size.x)),
             std::floor(std::clamp(down * (screen.y - size.y) + off, margin, margin + most.y - size.y))},
            size};
}

/// @param moved  whether a lab's own column is another one than it was
bool begin(const PanelContext& context, const LabInfo& lab, int before, bool moved, bool& open) {
    const Theme& theme = context.theme;
    const Bounds bounds = bounds_of(context, lab, before);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImGuiCond when =
        moved && lab.anchor == LabInfo::Anchor::Side ? ImGuiCond_Always : ImGuiCond_Appearing;
    ImGui::SetNextWindowSize(bounds.size, when);
    ImGui::SetNextWindowPos(bounds.low, when);
    ImGui::SetNextWindowSizeConstraints(
        {std::min(theme.px(440), bounds.size.x), std::min(theme.px(300), bounds.size.y)}, screen);
    return ImGui::Begin(
        lab.label, &open,
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav);
}

}  // namespace

std::span<const LabInfo> labs() {
    static constexpr LabInfo table[] = {
        {"interpolation", "Interpolation lab",
         "Data points to drag, every interpolation between them, and whether its slopes keep it monotone.",
         "thesis fig. 3.5, 3.6", [](LabState& s) -> bool& { return s.interpolation.open; },
         draw_interpolation_lab, 980, 700, LabInfo::Anchor::Middle},
        {"stencil", "Stencil lab", "The particles that ASLAM traces for a node, and how much each counts.",
         "thesis fig. 4.2, 4.3, table 4.1", [](LabState& s) -> bool& { return s.stencil.open; },
         draw_stencil_lab, 920, 560, LabInfo::Anchor::Middle},
        {"slice", "Slice",
         "What is shown, along a line through the field: overshoot, flattening and lag as curves.", "",
         [](LabState& s) -> bool& { return s.slice.open; }, draw_slice_window, 760, 400,
         LabInfo::Anchor::Bottom},
        {"inspector", "Inspector",
         "Click a cell to see where its value came from: the sum behind it, with its numbers. Key: I", "",
         [](LabState& s) -> bool& { return s.inspector.open; }, draw_inspector_window, 0, 0,
         LabInfo::Anchor::Side},
    };
    return table;
}

void draw_labs(PanelContext& context) {
    LabState& state = context.view.labs;
    state.under_pointer = false;
    const bool beside = state.side.beside_lessons;
    const bool moved = std::exchange(state.stood_beside_lessons, beside) != beside;
    int before = 0;
    for (const LabInfo& lab : labs()) {
        bool& open = lab.open(state);
        if (!open) continue;
        if (begin(context, lab, before++, moved, open)) {
            context.log.control("lab-window=" + std::string(lab.key));
            lab.draw(context);
        }
        state.under_pointer |= ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows |
                                                      ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        ImGui::End();
    }
}

bool close_top_lab(LabState& state) {
    bool* top = nullptr;
    int highest = -1;
    for (const LabInfo& lab : labs()) {
        ImGuiWindow* const window = ImGui::FindWindowByName(lab.label);
        if (!lab.open(state) || window == nullptr) continue;
        const int height = ImGui::FindWindowDisplayIndex(window);
        if (height < highest) continue;
        highest = height;
        top = &lab.open(state);
    }
    if (top != nullptr) *top = false;
    return top != nullptr;
}

}  // namespace whorl::app
