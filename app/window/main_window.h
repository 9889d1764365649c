// Everything in the window, frame by frame.
#pragma once

#include <memory>

#include "app/inspector/inspect_tool.h"
#include "app/labs/slice_tool.h"
#include "app/panels/field_area.h"
#include "app/panels/panel.h"
#include "app/tools/brush_tool.h"
#include "app/tools/view_tool.h"
#include "app/tutorial/lesson_player.h"
#include "app/ui/tooltip.h"
#include "app/window/field_painter.h"
#include "app/window/file_service.h"
#include "app/window/frame_clock.h"
#include "app/window/glfw_window.h"

namespace whorl::app {

/// The run, what is known of it, and what shows and steers it.
class MainWindow {
  public:
    /// @throws InputError if the scene's choices do not go together, std::runtime_error if the event log
    /// cannot
    ///         be written
    MainWindow(const WindowOptions& options, GlfwWindow& window);

    /// Waits for the next frame's time, and makes it.
    void frame();
    /// Whether something that was asked for is on its way to a file: frames bring it there.
    bool writes() const { return file_service_.writes(); }

  private:
    bool idle() const;
    void act_on(const InputEvent& event);
    void press_key(const InputEvent& event);
    void escape();
    void travel(int key);
    void type(const InputEvent& event);
    void take_run();
    void read_lesson();
    PanelContext context();
    void draw();

    GlfwWindow& window_;
    EventLog log_;
    FrameClock clock_;
    int warm_up_ = 5;           ///< frames that are not measured yet
    std::uint64_t serial_ = 0;  ///< of the moment on screen
    bool list_open_ = false;    ///< at the end of the last frame
    bool was_idle_ = false;     ///< before the last frame
    double last_activity_ = 0;  ///< when something last came in or moved, seconds of the clock
    Notifications notifications_;
    ViewSettings view_;
    MeasureView measure_view_;
    FileRequests files_;
    History history_;
    FrameLog frames_;
    Tooltip tooltip_;
    BrushTool brush_;
    ViewTool view_tool_;
    SliceTool slice_tool_;
    InspectTool inspect_tool_;
    FieldViewports place_;
    BackgroundRects backgrounds_;
    FieldPainter painter_;
    LaneFields fields_;
    LaneNames names_;
    std::vector<StepMeasures> measures_;
    std::unique_ptr<Player> player_;
    SessionClient client_;
    FileService file_service_;
    LessonPlayer lessons_;
};

}  // namespace whorl::app
