#include "app/panels/control_column.h"

#include <imgui.h>

#include <cstdio>
#include <utility>

namespace whorl::app {
namespace {

/// Opens a panel and scrolls to it.
void show(const char* title) {
    ImGui::GetStateStorage()->SetBool(ImGui::GetID(title), true);
    ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY(), 0);
}

}  // namespace

void ControlColumn::state_lines() {
    const Snapshot& s = run_.snapshot();
    const SessionSnapshot& session = run_.session();
    const Palette& palette = ui_.theme.palette;
    ImGui::PushFont(ui_.theme.title);
    ImGui::TextUnformatted("Whorl");
    ImGui::PopFont();
    char line[96];
    if (s.grid().dimensions() == 1) {
        std::snprintf(line, sizeof line, "%d cells  ·  step %ld  ·  t = %.2f", s.grid().nx, session.step,
                      session.time);
    } else {
        std::snprintf(line, sizeof line, "%d × %d  ·  step %ld  ·  t = %.2f", s.grid().nx, s.grid().ny,
                      session.step, session.time);
    }
    text(palette.text_dim, line);
    int end = 0;
    if (session.lanes.size() > 1)
        end = std::snprintf(line, sizeof line, "%zu lanes  ·  ", session.lanes.size());
    std::snprintf(line + end, sizeof line - static_cast<std::size_t>(end), "%.0f frames/s  ·  %.0f steps/s",
                  frames_.frames_per_second(), run_.steps_per_second());
    text(palette.text_dim, line);
    ImGui::Separator();
    ImGui::Dummy({0, ui_.theme.px(1)});
}

void ControlColumn::draw(std::string_view wanted) {
    state_lines();
    ImGui::BeginChild("panels", {0, 0}, false, ImGuiWindowFlags_NoNav);  // Tab shows another lane
    if (std::exchange(to_top_, false)) ImGui::SetScrollY(0);
    bool first = true;
    for (const Part& part : panels_) {
        const char* const title = part.entry->title;
        if (wanted == title) show(title);
        // What every run needs comes without a heading.
        const bool open = first || heading(ui_.theme, title, part.entry->open);
        ui_.log.control("panel=" + std::string(title));
        first = false;
        if (open) {
            ImGui::PushID(title);
            part.panel->draw();
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

}  // namespace whorl::app
