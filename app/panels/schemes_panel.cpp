// How quantities are advected: one column of choices, or two where velocity and scalars differ.
#include <imgui.h>

#include <cmath>

#include "app/panels/parameter_control.h"
#include "app/ui/widgets.h"

namespace whorl::app {

void draw_schemes_panel(PanelContext& context) {
    const Parameter& linked = parameter("linked");
    parameter_row(context, linked);
    if (!context.scene().linked) {
        const float left = ImGui::GetCursorPosX();
        const float gap = ImGui::GetStyle().ItemSpacing.x;
        const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
        text(context.theme.palette.series[1], "Velocity");
        ImGui::SameLine(left + half + gap);
        text(context.theme.palette.series[0], "Smoke and heat");
    }
    for (const Parameter& p : parameters()) {
        if (p.group == Parameter::Group::Schemes && &p != &linked) parameter_or_pair(context, p);
    }
}

}  // namespace whorl::app
