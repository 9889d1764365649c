// What a drag of the mouse does.
#include "app/panels/parameter_control.h"

namespace whorl::app {

void draw_brush_panel(PanelContext& context) {
    parameter_rows(context, Parameter::Group::Brush);
}

}  // namespace whorl::app
