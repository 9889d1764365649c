#include "app/window/main_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>
#include <sys/resource.h>

#include <future>
#include <utility>

#include "app/charts/measure_column.h"
#include "app/labs/labs.h"
#include "app/panels/control_column.h"
#include "app/panels/dialogs.h"
#include "app/panels/help_overlay.h"
#include "app/panels/timeline.h"
#include "app/scenes/presets.h"
#include "app/tutorial/lesson_panel.h"
#include "app/tutorial/tour_card.h"
#include "app/tutorial/tour_memory.h"
#include "app/window/layout.h"

namespace whorl::app {
namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin_column(const char* name, const Layout& layout, const Column& column, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos({column.x, layout.top});
    ImGui::SetNextWindowSize({column.width, layout.height});
    ImGui::Begin(name, nullptr, fixed | flags);
}

void begin_panel(const char* name, const Layout& layout, const Column& column, const Theme& theme,
                 BackgroundRects& backgrounds) {
    begin_column(name, layout, column, ImGuiWindowFlags_NoBackground);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low{column.x, layout.top};
    const ImVec2 high{column.x + column.width, layout.top + layout.height};
    list.PushClipRectFullScreen();
    backgrounds.add(list, low, high, ImGui::GetStyle().WindowRounding, theme.palette.panel);
    list.AddRect(low, high, theme.palette.border, ImGui::GetStyle().WindowRounding);
    list.PopClipRect();
}

/// Whether a list that a control has opened lies over the window.
bool list_open() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// Whether arrow keys and Enter choose in what is open; else they are the window's own.
void lists_take_keys(bool take) {
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags = take ? flags | ImGuiConfigFlags_NavEnableKeyboard : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
}

/// Takes the line of an open list that the arrow keys have come to: ImGui's own key for it is Space alone.
void take_line() {
    const ImGuiContext& gui = *ImGui::GetCurrentContext();
    if (!gui.NavDisableHighlight && gui.NavId != 0) ImGui::ActivateItem(gui.NavId);
}

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
    : window_(window), log_(options.trace), player_(make_player(options)), client_(*player_, notifications_) {
    client_.set_loaded(options.name);
    file_service_.opened(options.recording, options.name);
    if (!options.lesson.empty()) files_.open = options.lesson;
    player_->play(options.recording.step == 0);
    if (options.tour.value_or(!tour_seen())) view_.tour.begin();
}

/// Whether nothing has moved for a while and nobody has done anything, so that a few frames a second will do.
bool MainWindow::idle() const {
    constexpr double quiet = 2;  // seconds: the tooltip has come by then
    return clock_.time() > last_activity_ + quiet;
}

void MainWindow::frame() {
    const bool now_idle = idle();
    if (now_idle) window_.await_events(0.1);
    if (!std::exchange(was_idle_, now_idle) && now_idle) log_.event("rest", "");
    clock_.wait();
    // The first frames open the window and build fonts and shaders.
    if (warm_up_ > 0) {
        --warm_up_;
    } else if (!now_idle) {
        frames_.add(clock_.interval_ms(), clock_.work_ms());
    }
    notifications_.set_time(clock_.time());
    player_->begin_frame();
    const std::vector<InputEvent>& events = window_.begin_frame();
    take_run();
    for (const InputEvent& event : events) act_on(event);
    const std::uint64_t serial = client_.session().serial;
    if (std::exchange(serial_, serial) != serial || !events.empty() || client_.playing() ||
        file_service_.writes())
        last_activity_ = clock_.time();
    brush_.end_frame(client_);
    lessons_.set_open(view_.lessons, client_);
    draw();
    window_.end_frame();
    PanelContext seen = context();
    file_service_.end_frame(seen, clock_.time());
    if (files_.lesson) read_lesson();
    log_.frame(frames_, client_.steps_per_second(), client_.playing(), client_.session(), clock_.time());
}

/// Opens the panel on a lesson that has come from a file.
void MainWindow::read_lesson() {
    lessons_.begin_own(std::move(files_.lesson), client_, view_);
    view_.lessons = true;
    view_.shows_measures = false;
}

/// Takes the newest state, its measures, and what is shown of it with its range.
void MainWindow::take_run() {
    client_.watch(watched(view_, measure_view_));
    client_.begin_frame();
    const SessionSnapshot& session = client_.session();
    const bool new_run = player_->take_measures(measures_);
    history_.take(measures_, new_run);
    measures_.clear();
    names_.update(session.setup);
    lessons_.update(client_, view_);
    if (!available(*view_.shown, client_.snapshot())) view_.shown = views().front();
    if (session.lanes.size() == 1) {
        view_.compare = Compare::SideBySide;
        view_.difference = false;
    }
    fields_.update(session, *view_.shown, view_.difference);
    // Fields that stand still are shown on their own range, so that their picture depends on the step alone.
    const double seconds = client_.playing() ? 1e-3 * clock_.interval_ms() : ColourRange::at_once;
    view_.range.follow(*view_.shown, view_.difference, fields_.span(), seconds);
}

void MainWindow::act_on(const InputEvent& event) {
    using Kind = InputEvent::Kind;
    if (event.kind == Kind::Character && ImGui::GetIO().WantTextInput) return;
    if (view_.tour_in_sight(files_) && !ImGui::GetIO().WantTextInput && view_.tour.take(event)) return;
    if (view_tool_.take(event, place_, view_)) return;
    if (slice_tool_.take(event, place_, client_.session(), window_.theme().scale, view_.labs.slice)) return;
    if (inspect_tool_.take(event, place_, client_, view_)) return;
    if (lessons_.take(event, client_, view_)) return;
    switch (event.kind) {
        case Kind::Character:
            if (!files_.dialog && !list_open_) type(event);
            break;
        case Kind::Drop:
            files_.open = event.path;
            break;
        case Kind::Key:
            press_key(event);
            break;
        case Kind::KeyUp:
            if (event.code == GLFW_KEY_TAB) view_.peek = false;
            break;
        case Kind::Wheel: {
            const ImVec2 at = ImGui::GetIO().MousePos;
            if (place_.at(static_cast<double>(at.x), static_cast<double>(at.y)) == nullptr) break;
            const double radius = wheel_radius(client_.scene().brush.radius, event.y);
            client_.set(parameter("brush.radius"), radius);
            break;
        }
        default:
            brush_.take(event, place_);
    }
}

void MainWindow::press_key(const InputEvent& event) {
    if (!ImGui::GetIO().WantTextInput && !files_.dialog && !list_open_) travel(event.code);
    if (event.repeated) return;
    if (event.code == GLFW_KEY_F12) files_.take_picture = true;
    if (event.code == GLFW_KEY_ESCAPE) escape();
    if (event.code == GLFW_KEY_TAB && !ImGui::GetIO().WantTextInput) view_.peek = true;
    if (event.code == GLFW_KEY_ENTER || event.code == GLFW_KEY_KP_ENTER) {
        files_.enter = true;
        if (list_open_ && !files_.dialog) take_line();
    }
    if ((event.mods & GLFW_MOD_CONTROL) == 0) return;
    if (event.code == GLFW_KEY_S) files_.save_run = true;
    if (event.code == GLFW_KEY_O) files_.ask_open = true;
    if (event.code == GLFW_KEY_Q) window_.close();
}

/// Closes what lies on top.
void MainWindow::escape() {
    files_.escape = true;
    if (files_.dialog || ImGui::GetIO().WantTextInput) return;
    if (list_open_) {
        if (list_open()) ImGui::ClosePopupToLevel(0, true);
        return;
    }
    if (!std::exchange(view_.help, false)) close_top_lab(view_.labs);
}

/// Along the timeline.
void MainWindow::travel(int key) {
    if (key == GLFW_KEY_LEFT) walk(client_, -1);
    if (key == GLFW_KEY_RIGHT) walk(client_, 1);
    if (key == GLFW_KEY_HOME) client_.seek(0);
    if (key == GLFW_KEY_END) client_.seek(client_.session().last_step);
}

void MainWindow::type(const InputEvent& event) {
    if (event.code == '.') return client_.step();
    if (event.repeated) return;
    switch (event.code) {
        case ' ':
            return client_.play(!client_.playing());
        case 'r':
        case 'R':
            return client_.restart();
        case 'h':
        case 'H':
            view_.help = !view_.help;
            return;
        case 'i':
        case 'I':
            view_.labs.inspector.open = !view_.labs.inspector.open;
            return;
        case 'l':
        case 'L':
            view_.lessons = !view_.lessons || std::exchange(view_.shows_measures, false);
            return;
        case 'q':
        case 'Q':
            return window_.close();
        default:
            break;
    }
    const int digit = event.code - '1';
    if (digit < 0 || digit >= static_cast<int>(presets().size())) return;
    const Preset& preset = presets()[static_cast<std::size_t>(digit)];
    client_.load_scene(preset.key, preset.scene());
}

PanelContext MainWindow::context() {
    return {window_.theme(), client_, view_,  measure_view_, files_, history_,
            frames_,         fields_, names_, tooltip_,      log_,   backgrounds_};
}

void MainWindow::draw() {
    const SessionSnapshot& session = client_.session();
    const Theme& theme = window_.theme();
    PanelContext context = this->context();
    backgrounds_.clear();
    files_.dialog = false;
    const Layout layout =
        lay_out(theme, field_shape(session, view_), static_cast<float>(window_.framebuffer_width()),
                static_cast<float>(window_.framebuffer_height()), view_.lessons || view_.labs.inspector.open);
    const Column& side = inspector_column(layout, view_.lessons);
    view_.labs.side = {side.x, side.width, view_.lessons};

    begin_panel("controls", layout, layout.controls, theme, backgrounds_);
    draw_control_column(context);
    ImGui::End();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    begin_column("field", layout, layout.field,
                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    place_ = draw_field_area(context);
    ImGui::End();
    begin_panel("measures", layout, layout.measures, theme, backgrounds_);
    if (view_.lessons && !view_.shows_measures) {
        draw_lesson_panel(context, lessons_);
        view_.lessons = lessons_.open();
    } else {
        draw_measure_column(context);
    }
    ImGui::End();
    draw_labs(context);
    draw_open_dialog(context);
    draw_film_dialog(context);
    files_.enter = files_.escape = false;
    draw_tour(context);
    draw_help_overlay(context);
    tooltip_.end_frame();
    list_open_ = list_open();
    lists_take_keys(list_open_ && !files_.dialog);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (on_wipe_line(place_, static_cast<double>(mouse.x), static_cast<double>(mouse.y)))
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::Render();
    // A view chosen this frame has its field from the next one on.
    painter_.clear(theme, backgrounds_, window_.framebuffer_height());
    painter_.draw(session, fields_, view_, place_, theme, window_.framebuffer_height());
}

}  // namespace whorl::app
