// The table of panels, a line each.
#include "app/panels/panel.h"

namespace whorl::app {

std::span<const Panel> panels() {
    static constexpr Panel table[] = {
        {"Run", draw_run_panel},
        {"Lanes", draw_lanes_panel},
        {"Picture", draw_picture_panel, false},
        {"Schemes", draw_schemes_panel},
        {"Particles", draw_particles_panel},
        {"View", draw_view_panel},
        {"Forces", draw_forces_panel},
        {"Brush", draw_brush_panel},
        {"Time", draw_time_panel},
        {"Pressure", draw_pressure_panel},
        {"Domain", draw_domain_panel},
        {"Labs", draw_labs_panel},
    };
    return table;
}

}  // namespace whorl::app
