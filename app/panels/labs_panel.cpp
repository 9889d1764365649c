// Opens and closes the labs.
#include <imgui.h>

#include <cmath>

#include "app/labs/labs.h"
#include "app/ui/widgets.h"

namespace whorl::app {

void draw_labs_panel(PanelContext& context) {
    const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
    const float width = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
    int k = 0;
    for (const LabInfo& lab : labs()) {
        if (k++ % 2 != 0) ImGui::SameLine(0, gap);
        bool& open = lab.open(context.view.labs);
        if (chip(context.theme, lab.label, open, width)) open = !open;
        const std::string key = "lab=" + std::string(lab.key);
        context.log.control(key);
        context.tooltip.item(context.theme, key, {lab.label, lab.help, "", lab.source, ""});
    }
}

}  // namespace whorl::app
