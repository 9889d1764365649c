#include "app/window/main_window.h"

#include <imgui.h>
#include <sys/resource.h>

#include <future>
#include <utility>

#include "app/tutorial/tour_memory.h"

namespace whorl::app {
namespace {

/// A player whose threads give way to the window's: on Linux, threads inherit the niceness of their maker,
/// and only the calling thread's is changed here.
std::unique_ptr<Player> make_player(const WindowOptions& options) {
    return std::async(std::launch::async,
                      [&] {
                          constexpr int niceness = 10;
                          setpriority(PRIO_PROCESS, 0, niceness);
                          return std::make_unique<Player>(options.recording, options.threads);
                      })
        .get();
}

}  // namespace

MainWindow::MainWindow(const WindowOptions& options, GlfwWindow& window)
    : window_(window),
      log_(options.trace),
      player_(make_player(options)),
      features_(window.theme(), *player_, log_, notifications_),
      file_service_(features_.services, features_.run, features_.measures) {
    features_.run.set_loaded(options.name);
    file_service_.opened(options.recording, options.name);
    if (!options.lesson.empty()) features_.files.open = options.lesson;
    player_->play(options.recording.step == 0);
    if (options.tour.value_or(!tour_seen())) features_.tour.begin();
}

/// Whether nothing has moved for a while and nobody has done anything, so that a few frames a second will do.
bool MainWindow::idle() const {
    constexpr double quiet = 2;  // seconds: the tooltip has come by then
    return clock_.time() > last_activity_ + quiet;
}

void MainWindow::wait() {
    const bool now_idle = idle();
    if (now_idle) window_.await_events(0.1);
    if (!std::exchange(was_idle_, now_idle) && now_idle) log_.event("rest", "");
    clock_.wait();
    // The first frames open the window and build fonts and shaders.
    if (warm_up_ > 0) {
        --warm_up_;
    } else if (!now_idle) {
        features_.frames.add(clock_.interval_ms(), clock_.work_ms());
    }
}

void MainWindow::frame() {
    wait();
    SessionClient& run = features_.run;
    notifications_.set_time(clock_.time());
    player_->begin_frame();
    const std::vector<InputEvent>& events = window_.begin_frame();
    // Fields that stand still are shown on their own range, so that their picture depends on the step alone.
    features_.begin_frame(run.playing() ? 1e-3 * clock_.interval_ms() : ColourRange::at_once);
    for (const InputEvent& event : events) features_.take(event);
    if (features_.closes) window_.close();
    const std::uint64_t serial = run.session().serial;
    if (std::exchange(serial_, serial) != serial || !events.empty() || run.playing() ||
        file_service_.writes())
        last_activity_ = clock_.time();
    features_.end_input();
    draw();
    window_.end_frame();
    if (features_.tour.take_ended()) file_service_.note_tour();
    file_service_.end_frame(clock_.time());
    if (features_.files.lesson) read_lesson();
    log_.frame(features_.frames, run.steps_per_second(), run.playing(), run.session(), clock_.time());
}

/// Opens the panel on a lesson that has come from a file.
void MainWindow::read_lesson() {
    features_.lessons.begin_own(std::move(features_.files.lesson));
    features_.right_column.open_lessons();
}

void MainWindow::draw() {
    const Theme& theme = window_.theme();
    features_.draw(static_cast<float>(window_.framebuffer_width()),
                   static_cast<float>(window_.framebuffer_height()));
    ImGui::Render();
    // A view chosen this frame has its field from the next one on.
    painter_.clear(theme, features_.ui.backgrounds, window_.framebuffer_height());
    painter_.draw(features_.run.session(), features_.fields, features_.view, features_.viewports, theme,
                  window_.framebuffer_height());
}

}  // namespace whorl::app
