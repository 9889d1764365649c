// What is asked in a window of its own over all others.
#pragma once

#include "app/panels/panel.h"

namespace whorl::app {

/// Chooses a preset or a file to open. Shows while `files` says so; call once a frame.
void draw_open_dialog(PanelContext& context);
/// Chooses how an animation is made.
void draw_film_dialog(PanelContext& context);

/// Centres the next dialog. @param width points
bool begin_dialog(PanelContext& context, const char* title, float width);

/// Presets, and the runs and pictures of the current folder by name.
std::vector<RunEntry> runs_here();

}  // namespace whorl::app
