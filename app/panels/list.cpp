// The list of panels, a line each.
#include "app/panels/list.h"

namespace whorl::app {

Registry<PanelEntry>& panels() {
    static Registry<PanelEntry> list{"panel",
                                     {
                                         &run_panel,
                                         &lanes_panel,
                                         &picture_panel,
                                         &schemes_panel,
                                         &particles_panel,
                                         &view_panel,
                                         &forces_panel,
                                         &brush_panel,
                                         &time_panel,
                                         &pressure_panel,
                                         &domain_panel,
                                         &labs_panel,
                                     }};
    return list;
}

}  // namespace whorl::app
