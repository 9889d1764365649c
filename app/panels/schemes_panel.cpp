// How quantities are advected: one column of choices, or two where velocity and scalars differ.
#include <imgui.h>

#include <cmath>

#include "app/panels/list.h"
#include "app/panels/parameter_control.h"
#include "app/run/run_control.h"
#include "app/ui/ui.h"

namespace whorl::app {
namespace {

class SchemesPanel final : public Panel {
  public:
    SchemesPanel(Ui& ui, RunControl& run) : ui_(ui), run_(run) {}

    void draw() override {
        ParameterControls controls(ui_, run_);
        const Parameter& linked = parameter("linked");
        controls.row(linked);
        if (!run_.scene().linked) {
            const float left = ImGui::GetCursorPosX();
            const float gap = ImGui::GetStyle().ItemSpacing.x;
            const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - gap));
            text(ui_.theme.palette.series[1], "Velocity");
            ImGui::SameLine(left + half + gap);
            text(ui_.theme.palette.series[0], "Smoke and heat");
        }
        for (const Parameter& p : parameters()) {
            if (p.group == Parameter::Group::Schemes && &p != &linked) controls.row_or_pair(p);
        }
    }

  private:
    Ui& ui_;
    RunControl& run_;
};

}  // namespace

const PanelEntry schemes_panel{
    .key = "schemes", .title = "Schemes", .make = [](const Services& s) -> std::unique_ptr<Panel> {
        return std::make_unique<SchemesPanel>(s.ui, s.run);
    }};

}  // namespace whorl::app
