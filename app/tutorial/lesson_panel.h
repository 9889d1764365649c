// The lessons beside the field: a list to choose from, or a lesson's step with Back and Next.
#pragma once

#include "app/panels/panel.h"
#include "app/tutorial/lesson_player.h"

namespace whorl::app {

/// The least width of the column that the panel is drawn into, points: lessons' formulas fit it.
inline constexpr float lesson_column_width = 300;

/// Draws into the current window.
void draw_lesson_panel(PanelContext& context, LessonPlayer& lesson_player);

}  // namespace whorl::app
