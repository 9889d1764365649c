// The time step and the order of its phases.
#include "app/panels/parameter_control.h"

namespace whorl::app {

void draw_time_panel(PanelContext& context) {
    parameter_rows(context, Parameter::Group::Time);
}

}  // namespace whorl::app
