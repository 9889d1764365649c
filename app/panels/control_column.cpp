#include "app/panels/control_column.h"

#include <imgui.h>

#include <cstdio>

#include "app/ui/widgets.h"
#include "core/base/number.h"

namespace whorl::app {
namespace {

void state_lines(PanelContext& context) {
    const Snapshot& s = context.snapshot();
    const SessionSnapshot& session = context.client.session();
    const Palette& palette = context.theme.palette;
    ImGui::PushFont(context.theme.title);
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
                  context.frames.frames_per_second(), context.client.steps_per_second());
    text(palette.text_dim, line);
    ImGui::Separator();
    ImGui::Dummy({0, context.theme.px(1)});
}

/// Opens a panel and scrolls to it.
void show(const Panel& panel) {
    ImGui::GetStateStorage()->SetBool(ImGui::GetID(panel.title), true);
    ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY(), 0);
}

}  // namespace

void draw_control_column(PanelContext& context) {
    state_lines(context);
    ImGui::BeginChild("panels", {0, 0}, false, ImGuiWindowFlags_NoNav);  // Tab shows another lane
    if (context.view.tour.take_back_up()) ImGui::SetScrollY(0);
    bool first = true;
    for (const Panel& panel : panels()) {
        if (context.view.tour.wanted_panel() == std::string_view(panel.title)) show(panel);
        // What every run needs comes without a heading.
        const bool open = first || heading(context.theme, panel.title, panel.open);
        context.log.control("panel=" + std::string(panel.title));
        first = false;
        if (open) {
            ImGui::PushID(panel.title);
            panel.draw(context);
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

}  // namespace whorl::app
