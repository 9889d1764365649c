#include "app/window/shortcuts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include <cctype>
#include <string>
#include <utility>

#include "app/scenes/presets.h"
#include "app/window/features.h"

namespace whorl::app {
namespace {

using Kind = InputEvent::Kind;

bool typed(const InputEvent& event, char character) {
    return event.kind == Kind::Character && !event.repeated && event.code < 128 &&
           std::tolower(event.code) == character;
}

bool pressed(const InputEvent& event, int key) {
    return event.kind == Kind::Key && !event.repeated && event.code == key;
}

bool pressed_with_control(const InputEvent& event, int key) {
    return pressed(event, key) && (event.mods & GLFW_MOD_CONTROL) != 0;
}

/// Takes the line of an open list that the arrow keys have come to: ImGui's own key for it is Space alone.
void take_line() {
    const ImGuiContext& gui = *ImGui::GetCurrentContext();
    if (!gui.NavDisableHighlight && gui.NavId != 0) ImGui::ActivateItem(gui.NavId);
}

bool take_preset(const InputEvent& event, Features& f) {
    const int digit = event.code - '1';
    if (event.kind != Kind::Character || event.repeated || digit < 0 ||
        digit >= static_cast<int>(presets().size()))
        return false;
    const Preset& preset = presets()[static_cast<std::size_t>(digit)];
    f.run.load_scene(preset.key, preset.scene());
    return true;
}

/// Goes a step back or on, also while the key is held.
bool take_arrow(const InputEvent& event, Features& f) {
    const bool left = event.code == GLFW_KEY_LEFT;
    if (event.kind != Kind::Key || (!left && event.code != GLFW_KEY_RIGHT)) return false;
    f.run.move_by(left ? -1 : 1);
    return true;
}

bool take_end(const InputEvent& event, Features& f) {
    const bool home = event.code == GLFW_KEY_HOME;
    if (event.kind != Kind::Key || (!home && event.code != GLFW_KEY_END)) return false;
    f.run.seek(home ? 0 : f.run.session().last_step);
    return true;
}

/// Closes what lies on top.
bool take_escape(const InputEvent& event, Features& f) {
    if (!pressed(event, GLFW_KEY_ESCAPE)) return false;
    f.files.escape = true;
    if (f.files.dialog || ImGui::GetIO().WantTextInput) return true;
    if (f.list_open) {
        if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
            ImGui::ClosePopupToLevel(0, true);
    } else if (!std::exchange(f.help.open, false)) {
        f.labs.close_top();
    }
    return true;
}

bool take_enter(const InputEvent& event, Features& f) {
    if (!pressed(event, GLFW_KEY_ENTER) && !pressed(event, GLFW_KEY_KP_ENTER)) return false;
    f.files.enter = true;
    if (f.list_open && !f.files.dialog) take_line();
    return true;
}

bool take_lessons(const InputEvent& event, Features& f) {
    if (!typed(event, 'l')) return false;
    if (f.right_column.shows_lessons()) {
        f.right_column.lessons = false;
    } else {
        f.right_column.open_lessons();
    }
    return true;
}

/// Sets a flag at a key.
bool sets(bool is_key, bool& flag) {
    if (is_key) flag = true;
    return is_key;
}

bool toggles(bool is_key, bool& flag) {
    if (is_key) flag = !flag;
    return is_key;
}

std::string preset_digits() {
    return "1 – " + std::to_string(presets().size());
}

}  // namespace

std::span<const Shortcut> run_shortcuts() {
    static const std::string digits = preset_digits();
    static const Shortcut table[] = {
        {"Space", "play, pause",
         [](const InputEvent& e, Features& f) {
             if (!typed(e, ' ')) return false;
             f.run.play(!f.run.playing());
             return true;
         }},
        {".", "one step",
         [](const InputEvent& e, Features& f) {
             if (e.kind != Kind::Character || e.code != '.') return false;  // also while it is held
             f.run.step();
             return true;
         }},
        {"R", "reset",
         [](const InputEvent& e, Features& f) {
             if (!typed(e, 'r')) return false;
             f.run.restart();
             return true;
         }},
        {"← →", "a step back, a step on", take_arrow},
        {"Home, End", "the run's first and last step", take_end},
        {digits, "presets", take_preset},
    };
    return table;
}

std::span<const Shortcut> window_shortcuts() {
    static constexpr Shortcut table[] = {
        {"Ctrl+O", "open a scene, a run or a picture",
         [](const InputEvent& e, Features& f) {
             return sets(pressed_with_control(e, GLFW_KEY_O), f.files.ask_open);
         },
         true},
        {"Ctrl+S", "save the run",
         [](const InputEvent& e, Features& f) {
             return sets(pressed_with_control(e, GLFW_KEY_S), f.files.save_run);
         },
         true},
        {"I", "inspector: click a cell; Shift+arrow goes on",
         [](const InputEvent& e, Features& f) { return toggles(typed(e, 'i'), f.labs.open("inspector")); }},
        {"L", "lessons; Page Up and Down turn their steps", take_lessons},
        {"F12", "picture as PNG, which carries the run",
         [](const InputEvent& e, Features& f) {
             return sets(pressed(e, GLFW_KEY_F12), f.files.take_picture);
         },
         true},
        {"H", "this help",
         [](const InputEvent& e, Features& f) { return toggles(typed(e, 'h'), f.help.open); }},
        {"Esc", "close this, a dialog or the top lab", take_escape, true},
        {"Q, Ctrl+Q", "quit", [](const InputEvent& e, Features& f) { return sets(typed(e, 'q'), f.closes); }},
        {"", "",
         [](const InputEvent& e, Features& f) { return sets(pressed_with_control(e, GLFW_KEY_Q), f.closes); },
         true},
        {"", "", take_enter, true},
    };
    return table;
}

std::span<const KeyHelp> gestures() {
    static constexpr KeyHelp table[] = {
        {"Rest on a control", "what it does, and where it comes from"},
        {"Ctrl+click a slider", "type a value"},
        {"Right-click a control", "back to the value of all lanes"},
        {"Drop a file", "open a scene, a run, a lesson or a picture"},
    };
    return table;
}

}  // namespace whorl::app
