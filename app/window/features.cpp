#include "app/window/features.h"

#include <imgui.h>

#include "app/panels/field_layout.h"
#include "app/panels/list.h"
#include "app/window/lists.h"
#include "app/window/shortcuts.h"

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
bool any_list_open() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// Whether arrow keys and Enter choose in what is open; else they are the window's own.
void lists_take_keys(bool take) {
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags = take ? flags | ImGuiConfigFlags_NavEnableKeyboard : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
}

}  // namespace

Features::Features(const Theme& theme, Player& player, EventLog& log, Notifications& notifications)
    : ui(theme, log, notifications),
      run(player, notifications),
      services{ui, run, view, fields, history, frames, files, right_column, labs, shared},
      controls(ui, run, frames),
      field_area(ui, run, view, fields, layers),
      measure_column(services, measures),
      lessons(run, view),
      lesson_panel(ui, lessons, right_column),
      tour_card(ui, tour),
      help(ui, tour),
      open_dialog(ui, files),
      film_dialog(ui, run, files),
      player_(player) {
    for (const LabEntry* lab : app::labs().all()) labs.add(*lab, services);
    for (const ToolEntry* tool : tools().all()) layers.add(*tool, services);
    for (const OverlayEntry* overlay : overlays().all()) layers.add(*overlay, services);
    for (const PanelEntry* panel : panels().all()) controls.add(*panel, services);
    note_keys();
}

/// The rows of the help, from those who act on the keys.
void Features::note_keys() {
    const auto append = [](std::vector<KeyHelp>& rows, const auto& more) {
        for (const auto& row : more) {
            if (!row.what.empty()) rows.push_back({row.keys, row.what});
        }
    };
    append(key_help_, run_shortcuts());
    for (const ToolEntry* tool : tools().all()) {
        append(mouse_help_, tool->mouse);
        append(key_help_, tool->keys);
    }
    append(mouse_help_, gestures());
    append(key_help_, window_shortcuts());
}

void Features::begin_frame(double seconds) {
    Watch watch{.node = inspection().watched(), .limiters = view.counts_limited()};
    if (!right_column.shows_lessons()) watch.measures = measures_in_sight(measures.tab);
    run.watch(watch);
    run.begin_frame();
    const SessionSnapshot& session = run.session();
    const bool new_run = player_.take_measures(step_measures_);
    history.take(step_measures_, new_run);
    step_measures_.clear();
    lessons.update();
    if (!available(*view.shown, run.snapshot())) view.shown = views().front();
    if (session.lanes.size() == 1) {
        view.compare = Compare::SideBySide;
        view.difference = false;
    }
    fields.update(session, *view.shown, view.difference);
    view.range.follow(*view.shown, view.difference, fields.span(), seconds);
}

void Features::take(const InputEvent& event) {
    using Kind = InputEvent::Kind;
    const bool typing = ImGui::GetIO().WantTextInput;
    if (event.kind == Kind::Character && typing) return;
    if (tour_in_sight() && !typing && tour.take(event)) return;
    if (layers.take(event, viewports) || lessons.take(event)) return;
    if (event.kind == Kind::Drop) files.open = event.path;
    const bool free = !typing && !files.dialog && !list_open;
    for (const auto& shortcuts : {run_shortcuts(), window_shortcuts()}) {
        for (const Shortcut& shortcut : shortcuts) {
            if ((free || shortcut.anywhere) && shortcut.take(event, *this)) return;
        }
    }
}

void Features::end_input() {
    layers.end_frame();
    lessons.set_open(right_column.lessons);
}

void Features::draw(float width, float height) {
    const Theme& theme = ui.theme;
    ui.backgrounds.clear();
    files.dialog = false;
    layout = lay_out(theme, field_shape(run.session(), view), width, height,
                     right_column.lessons || inspection().open);
    const Column& side = inspector_column(layout, right_column.lessons);

    begin_panel("controls", layout, layout.controls, theme, ui.backgrounds);
    if (tour.take_back_up()) controls.to_top();
    controls.draw(tour.wanted_panel());
    ImGui::End();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    begin_column("field", layout, layout.field,
                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    viewports = field_area.draw(help.open || labs.under_pointer() || tour.under_pointer());
    ImGui::End();
    begin_panel("measures", layout, layout.measures, theme, ui.backgrounds);
    draw_measures();
    ImGui::End();
    labs.draw(ui, {side.x, side.width, right_column.lessons});
    open_dialog.draw();
    film_dialog.draw();
    files.enter = files.escape = false;
    if (tour_in_sight()) tour_card.draw();
    help.draw(mouse_help_, key_help_);
    ui.tooltip.end_frame();
    list_open = any_list_open();
    lists_take_keys(list_open && !files.dialog);
}

/// Or the lesson in their place.
void Features::draw_measures() {
    if (right_column.shows_lessons()) {
        lesson_panel.draw();
        right_column.lessons = lessons.open();
        return;
    }
    measure_column.draw();
}

}  // namespace whorl::app
