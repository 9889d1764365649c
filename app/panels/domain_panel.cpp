// The size of the domain, its cells and its sides.
#include "app/panels/parameter_control.h"

namespace whorl::app {

void draw_domain_panel(PanelContext& context) {
    parameter_rows(context, Parameter::Group::Domain);
}

}  // namespace whorl::app
