// What stands at the right of the fields: the measures, or a lesson in their place.
#pragma once

namespace whorl::app {

struct RightColumn {
    bool lessons = false;         ///< the lessons are open
    bool shows_measures = false;  ///< in the lesson's place, for a while

    bool shows_lessons() const { return lessons && !shows_measures; }
    void open_lessons() {
        lessons = true;
        shows_measures = false;
    }
};

}  // namespace whorl::app
