#include "app/panels/lesson_walk.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

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

void look(const LessonStep& step, Remote& remote, ViewState& view) {
    view.shown = step.view;
    view.difference = step.mode == LessonMode::Difference;
    view.compare = compare_of(step.mode);
    view.window = {};
    // The first lane, with the second as the other one.
    if (remote.session().lanes.size() > 1) remote.select(1);
    remote.select(0);
}

}  // namespace

void LessonWalk::begin(const Lesson& lesson, Remote& remote) {
    open_ = true;
    lesson_ = &lesson;
    enter(0, remote);
}

void LessonWalk::next(Remote& remote) {
    if (lesson_ != nullptr && !last()) enter(place_ + 1, remote);
}

void LessonWalk::back(Remote& remote) {
    if (lesson_ != nullptr && !first()) enter(place_ - 1, remote);
}

void LessonWalk::enter(std::size_t place, Remote& remote) {
    place_ = place;
    turned_ = true;
    show(remote);
}

void LessonWalk::show(Remote& remote) {
    remote.play(false);
    left_ = remote.session().run;
    remote.load(step().scene, step().recording);
}

bool LessonWalk::take(const InputEvent& event, Remote& remote) {
    if (!open_ || lesson_ == nullptr || event.kind != InputEvent::Kind::Key) return false;
    if (event.code != GLFW_KEY_PAGE_DOWN && event.code != GLFW_KEY_PAGE_UP) return false;
    if (event.repeated) return true;
    if (event.code == GLFW_KEY_PAGE_DOWN) {
        next(remote);
    } else {
        back(remote);
    }
    return true;
}

bool LessonWalk::begun(const Remote& remote) const {
    const SessionSnapshot& session = remote.session();
    const Recording& recording = step().recording;
    // Turning pages quickly, another step's run may begin in between. Commands may change a setup.
    return session.run != *left_ && (!recording.commands.empty() || session.setup == recording.setup);
}

void LessonWalk::update(Remote& remote, ViewState& view) {
    if (lesson_ == nullptr || !left_ || !begun(remote)) return;
    // A view may have nothing to show before the step's moment.
    look(step(), remote, view);
    if (!remote.sought()) left_.reset();
}

}  // namespace whorl::app
