#include "app/run/lab_windows.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/ui/ui.h"
#include "core/base/error.h"

namespace whorl::app {
namespace {

/// A window's place and size, pixels.
struct Bounds {
    ImVec2 low, size;
};

/// Inside the screen, a little off the labs that are open already.
Bounds bounds_of(const Theme& theme, const LabEntry& lab, const LabWindows::Side& side, int before) {
    using Anchor = LabEntry::Anchor;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float margin = theme.px(8);
    const ImVec2 most{screen.x - 2 * margin, screen.y - 2 * margin};
    if (lab.anchor == Anchor::Side) return {{side.x, margin}, {side.width, most.y}};
    const ImVec2 size{std::min(theme.px(lab.width), most.x), std::min(theme.px(lab.height), most.y)};
    const float down = lab.anchor == Anchor::Bottom ? 1 : 0.5f;
    const float off = theme.px(18) * static_cast<float>(before);
    return {{std::floor(std::clamp(0.5f * (screen.x - size.x) + off, margin, margin + most.x - size.x)),
             std::floor(std::clamp(down * (screen.y - size.y) + off, margin, margin + most.y - size.y))},
            size};
}

/// @param moved  whether a lab's own column is another one than it was
bool begin(const Theme& theme, const LabEntry& lab, const Bounds& bounds, bool moved, bool& open) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImGuiCond when =
        moved && lab.anchor == LabEntry::Anchor::Side ? ImGuiCond_Always : ImGuiCond_Appearing;
    ImGui::SetNextWindowSize(bounds.size, when);
    ImGui::SetNextWindowPos(bounds.low, when);
    ImGui::SetNextWindowSizeConstraints(
        {std::min(theme.px(440), bounds.size.x), std::min(theme.px(300), bounds.size.y)}, screen);
    return ImGui::Begin(
        lab.label, &open,
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav);
}

}  // namespace

bool& LabWindows::open(std::string_view key) const {
    for (const Window& window : windows_) {
        if (window.entry->key == key) return window.lab->open();
    }
    throw InputError("unknown lab \"" + std::string(key) + "\"");
}

void LabWindows::draw(Ui& ui, const Side& side) {
    under_pointer_ = false;
    const bool moved = std::exchange(stood_beside_lessons_, side.beside_lessons) != side.beside_lessons;
    int before = 0;
    for (const Window& window : windows_) {
        bool& open = window.lab->open();
        if (!open) continue;
        const Bounds bounds = bounds_of(ui.theme, *window.entry, side, before++);
        if (begin(ui.theme, *window.entry, bounds, moved, open)) {
            ui.log.control("lab-window=" + std::string(window.entry->key));
            window.lab->draw();
        }
        under_pointer_ |= ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows |
                                                 ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        ImGui::End();
    }
}

bool LabWindows::close_top() const {
    bool* top = nullptr;
    int highest = -1;
    for (const Window& window : windows_) {
        ImGuiWindow* const shown = ImGui::FindWindowByName(window.entry->label);
        if (!window.lab->open() || shown == nullptr) continue;
        const int height = ImGui::FindWindowDisplayIndex(shown);
        if (height < highest) continue;
        highest = height;
        top = &window.lab->open();
    }
    if (top != nullptr) *top = false;
    return top != nullptr;
}

}  // namespace whorl::app
