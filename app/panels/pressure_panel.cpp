// The pressure solver.
#include "app/panels/parameter_control.h"

namespace whorl::app {

void draw_pressure_panel(PanelContext& context) {
    parameter_rows(context, Parameter::Group::Pressure);
}

}  // namespace whorl::app
