// The keys that act on the run and the window, each with its row of the help.
#pragma once

#include <span>
#include <string_view>

#include "app/run/tool.h"

namespace whorl::app {

class Features;

struct Shortcut {
    std::string_view keys, what;  ///< as the help writes them; it leaves out what says nothing
    /// @return whether the event was this key
    bool (*take)(const InputEvent& event, Features& features);
    bool anywhere = false;  ///< also while text is typed, or a dialog or a list is open
};

/// What steers the run.
std::span<const Shortcut> run_shortcuts();

/// Files, what is shown beside the fields, and the window.
std::span<const Shortcut> window_shortcuts();

/// What the mouse does beside the tools' gestures.
std::span<const KeyHelp> gestures();

}  // namespace whorl::app
