// The pressure solver, and how it did in the last projection.
#include <imgui.h>

#include <cmath>
#include <string>

#include "app/panels/list.h"
#include "app/panels/parameter_control.h"
#include "app/run/run_control.h"
#include "app/ui/ui.h"
#include "core/base/number.h"
#include "core/pressure/solver.h"

namespace whorl::app {
namespace {

/// Who acted, and at what cost.
std::string report(const Measures& m) {
    std::string text(m.pressure.solver);
    if (m.pressure.iterations > 0) text += " · " + std::to_string(m.pressure.iterations) + " iterations";
    text += " · residual " + reading(m.pressure.residual);
    text += "\nset-up " + figure(m.pressure.setup_ms, 3) + " ms · solve " + figure(m.pressure.solve_ms, 3) +
            " ms";
    if (std::abs(m.removed_mean) > 1e-9) text += "\nremoved mean ∇·u " + reading(m.removed_mean);
    return text;
}

class PressurePanel final : public Panel {
  public:
    PressurePanel(Ui& ui, RunControl& run) : ui_(ui), run_(run) {}

    void draw() override {
        ParameterControls(ui_, run_).rows(Parameter::Group::Pressure);
        const Measures& m = run_.snapshot().measures;
        if (m.pressure.solver.empty()) return;  // nothing has been projected
        ImGui::PushFont(ui_.theme.small);
        ImGui::PushTextWrapPos(0);
        text(ui_.theme.palette.text_dim, report(m));
        if (!m.pressure_unsupported_reason.empty()) {
            const std::string_view chosen = pressure_solvers()[run_.scene().pressure].info.label;
            text(ui_.theme.palette.text_dim,
                 "instead of " + std::string(chosen) + ": " + std::string(m.pressure_unsupported_reason));
        }
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
    }

  private:
    Ui& ui_;
    RunControl& run_;
};

}  // namespace

const PanelEntry pressure_panel{
    .key = "pressure", .title = "Pressure", .make = [](const Services& s) -> std::unique_ptr<Panel> {
        return std::make_unique<PressurePanel>(s.ui, s.run);
    }};

}  // namespace whorl::app
