#include "app/window/window.h"

#include "app/window/main_window.h"

namespace whorl::app {

int run_window(const WindowOptions& options) {
    GlfwWindow window(options);
    Workbench workbench(options, window);
    while (!window.closing()) workbench.frame();
    window.hide();  // at once, though the solver may still be in the middle of a long step
    while (workbench.writes()) workbench.frame();
    return 0;
}

}  // namespace whorl::app
