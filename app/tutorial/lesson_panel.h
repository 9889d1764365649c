// The lessons beside the field: a list to choose from, or a lesson's step with Back and Next.
#pragma once

#include "app/run/right_column.h"
#include "app/tutorial/lesson_player.h"
#include "app/ui/ui.h"

namespace whorl::app {

/// The least width of the column that the panel is drawn into, points: lessons' formulas fit it.
inline constexpr float lesson_column_width = 300;

class LessonPanel {
  public:
    LessonPanel(Ui& ui, LessonPlayer& player, RightColumn& column)
        : ui_(ui), player_(player), column_(column) {}

    /// Draws into the current window.
    void draw();

  private:
    /// The first line: where the student is, and the ways out.
    void draw_top();
    void draw_list();
    /// A lesson to choose, as wide as the column.
    void draw_entry(const Lesson& lesson, int number);
    void draw_step();
    void draw_buttons();
    /// To the next step; from the last one to the next lesson, and from the last lesson to the list.
    void draw_next_button();

    Ui& ui_;
    LessonPlayer& player_;
    RightColumn& column_;
};

}  // namespace whorl::app
