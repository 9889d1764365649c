// Opens and closes the labs.
#include <imgui.h>

#include <cmath>

#include "app/panels/list.h"
#include "app/run/lab_windows.h"
#include "app/ui/ui.h"

namespace whorl::app {
namespace {

class LabsPanel final : public Panel {
  public:
    LabsPanel(Ui& ui, LabWindows& labs) : ui_(ui), labs_(labs) {}

    void draw() override {
        const float gap = std::floor(0.5f * ImGui::GetStyle().ItemSpacing.x);
        const float width = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
        int k = 0;
        for (const LabWindows::Window& window : labs_.all()) {
            if (k++ % 2 != 0) ImGui::SameLine(0, gap);
            const LabEntry& lab = *window.entry;
            bool& open = window.lab->open();
            if (ui_.chip(lab.label, "lab=" + std::string(lab.key), open, width,
                         {lab.label, lab.help, "", lab.source, ""}))
                open = !open;
        }
    }

  private:
    Ui& ui_;
    LabWindows& labs_;
};

}  // namespace

const PanelEntry labs_panel{
    .key = "labs", .title = "Labs", .make = [](const Services& s) -> std::unique_ptr<Panel> {
        return std::make_unique<LabsPanel>(s.ui, s.labs);
    }};

}  // namespace whorl::app
