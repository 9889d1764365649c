#include "app/tutorial/lesson_player.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace whorl::app {
namespace {

Compare compare_of(LessonMode mode) {
    switch (mode) {
        case LessonMode::One:
            return Compare::One;
        case LessonMode::Wipe:
            return Compare::Wipe;
        case LessonMode::SideBySide:
        case LessonMode::Difference:
            break;
    }
    return Compare::SideBySide;
}

void look(const LessonStep& step, RunControl& run, ViewSettings& view) {
    view.shown = step.view;
    view.difference = step.mode == LessonMode::Difference;
    view.compare = compare_of(step.mode);
    view.window = {};
    // The first lane, with the second as the other one.
    if (run.session().lanes.size() > 1) run.select(1);
    run.select(0);
}

}  // namespace

void LessonPlayer::set_open(bool open) {
    const bool closes = open_ && !open;
    open_ = open;
    if (!closes) return;
    if (saved_run_.holds(run_)) left_.reset();
    saved_run_.give_back(run_);
}

void LessonPlayer::begin(const Lesson& lesson) {
    open_ = true;
    lesson_ = &lesson;
    enter(0);
}

void LessonPlayer::begin_own(std::shared_ptr<const Lesson> lesson) {
    own_ = std::move(lesson);
    begin(*own_);
}

void LessonPlayer::next() {
    if (lesson_ != nullptr && !last()) enter(place_ + 1);
}

void LessonPlayer::back() {
    if (lesson_ != nullptr && !first()) enter(place_ - 1);
}

const Lesson* LessonPlayer::next_lesson() const {
    const std::span<const Lesson> all = lessons();
    const auto here = std::find_if(all.begin(), all.end(), [&](const Lesson& l) { return &l == lesson_; });
    return here == all.end() || here + 1 == all.end() ? nullptr : &*(here + 1);
}

void LessonPlayer::enter(std::size_t place) {
    place_ = place;
    turned_ = true;
    show();
}

void LessonPlayer::show() {
    left_ = run_.session().run;
    saved_run_.load_over(step().scene, step().recording, run_, view_);
}

bool LessonPlayer::take(const InputEvent& event) {
    if (!open_ || lesson_ == nullptr || event.kind != InputEvent::Kind::Key) return false;
    if (event.code != GLFW_KEY_PAGE_DOWN && event.code != GLFW_KEY_PAGE_UP) return false;
    if (event.repeated) return true;
    if (event.code == GLFW_KEY_PAGE_DOWN) {
        next();
    } else {
        back();
    }
    return true;
}

bool LessonPlayer::begun() const {
    const SessionSnapshot& session = run_.session();
    const Recording& recording = step().recording;
    // Turning pages quickly, another step's run may begin in between. Commands may change a setup.
    return session.run != *left_ && (!recording.commands.empty() || session.setup == recording.setup);
}

void LessonPlayer::update() {
    saved_run_.update(run_, view_);
    if (lesson_ == nullptr || !left_ || !begun()) return;
    // A view may have nothing to show before the step's moment.
    look(step(), run_, view_);
    if (!run_.seek_target()) left_.reset();
}

}  // namespace whorl::app
