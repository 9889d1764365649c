// What drives the flow.
#include "app/panels/parameter_control.h"

namespace whorl::app {

void draw_forces_panel(PanelContext& context) {
    parameter_rows(context, Parameter::Group::Forces);
}

}  // namespace whorl::app
