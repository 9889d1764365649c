// A student's way through the lessons: which one, which step, and its run and view on screen.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "app/lessons/lesson.h"
#include "app/run/run_control.h"
#include "app/run/saved_run.h"
#include "app/run/view_settings.h"
#include "app/ui/input_event.h"

namespace whorl::app {

/// Where a student is. A step is shown in one go: its run is loaded, paused, and once it stands at the step's
/// moment it is looked at as the step says.
class LessonPlayer {
  public:
    LessonPlayer(RunControl& run, ViewSettings& view) : run_(run), view_(view) {}

    /// Whether the panel is open.
    bool open() const { return open_; }
    /// Closed, it gives back the run that was on screen before the lessons' own; one that someone has loaded
    /// since then stays.
    void set_open(bool open);
    /// Whether there is a run to give back.
    bool keeps_run() const { return saved_run_.holds(run_); }

    /// The lesson that is read; null while one is chosen.
    const Lesson* lesson() const { return lesson_; }
    std::size_t place() const { return place_; }
    const LessonStep& step() const { return lesson_->steps[place_]; }
    bool first() const { return place_ == 0; }
    bool last() const { return place_ + 1 == lesson_->steps.size(); }
    /// The lesson that comes after this one in the list; null after the last one, and after one not listed.
    const Lesson* next_lesson() const;

    /// Opens the panel on a lesson's first step.
    /// @param lesson  must live as long as it is read
    void begin(const Lesson& lesson);
    /// The same with a lesson from a file, which stays in the list until another one is opened.
    void begin_own(std::shared_ptr<const Lesson> lesson);
    /// The last lesson from a file; null if there is none.
    const Lesson* own() const { return own_.get(); }
    /// Back to the list of lessons; the run stays.
    void leave() { lesson_ = nullptr; }
    void next();
    void back();
    /// The step's run and view again, whatever has been changed since.
    void show();
    /// Turns to the next step at PageDown and back at PageUp, while a lesson is read.
    /// @return whether the event was one of them
    bool take(const InputEvent& event);
    /// Looks at the shown run as the step says; call once a frame.
    void update();
    /// Whether another step was entered since the last call.
    bool take_turned() { return std::exchange(turned_, false); }

  private:
    void enter(std::size_t place);
    bool begun() const;

    RunControl& run_;
    ViewSettings& view_;
    bool open_ = false;
    std::shared_ptr<const Lesson> own_;
    const Lesson* lesson_ = nullptr;
    std::size_t place_ = 0;
    bool turned_ = false;
    SavedRun saved_run_;
    std::optional<int> left_;  ///< the run before, while the step's has not come to its moment
};

}  // namespace whorl::app
