// The particles that ASLAM traces for each node.
#include "app/panels/parameter_control.h"

namespace whorl::app {

void draw_particles_panel(PanelContext& context) {
    parameter_rows(context, Parameter::Group::Particles);
}

}  // namespace whorl::app
