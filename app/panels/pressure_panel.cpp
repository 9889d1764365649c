// The pressure solver, and how it did in the last projection.
#include <imgui.h>

#include <cmath>
#include <string>

#include "app/panels/parameter_control.h"
#include "app/ui/widgets.h"
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

}  // namespace

void draw_pressure_panel(PanelContext& context) {
    parameter_rows(context, Parameter::Group::Pressure);
    const Measures& m = context.snapshot().measures;
    if (m.pressure.solver.empty()) return;  // nothing has been projected
    ImGui::PushFont(context.theme.small);
    ImGui::PushTextWrapPos(0);
    text(context.theme.palette.text_dim, report(m));
    if (!m.pressure_why_not.empty()) {
        const std::string_view chosen = pressure_solvers()[context.scene().pressure].info.label;
        text(context.theme.palette.text_dim,
             "instead of " + std::string(chosen) + ": " + std::string(m.pressure_why_not));
    }
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

}  // namespace whorl::app
