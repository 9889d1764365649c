#include "app/window/window.h"

#include "app/window/main_window.h"

namespace whorl::app {

int run_window(const WindowOptions& options) {
    GlfwWindow window(options);
    MainWindow main_window(options, window);
    while (!window.closing()) main_window.frame();
    window.hide();  // at once, though the solver may still be in the middle of a long step
    while (main_window.writes()) main_window.frame();
    return 0;
}

}  // namespace whorl::app
