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

void look(const LessonStep& step, SessionClient& client, ViewSettings& view) {
    view.shown = step.view;
    view.difference = step.mode == LessonMode::Difference;
    view.compare = compare_of(step.mode);
    view.window = {};
    // The first lane, with the second as the other one.
    if (client.session().lanes.size() > 1) client.select(1);
    client.select(0);
}

}  // namespace

void LessonPlayer::set_open(bool open, SessionClient& client) {
    const bool closes = open_ && !open;
    open_ = open;
    if (!closes) return;
    if (saved_run_.holds(client)) left_.reset();
    saved_run_.give_back(client);
}

void LessonPlayer::begin(const Lesson& lesson, SessionClient& client, const ViewSettings& view) {
    open_ = true;
    lesson_ = &lesson;
    enter(0, client, view);
}

void LessonPlayer::begin_own(std::shared_ptr<const Lesson> lesson, SessionClient& client,
                             const ViewSettings& view) {
    own_ = std::move(lesson);
    begin(*own_, client, view);
}

void LessonPlayer::next(SessionClient& client, const ViewSettings& view) {
    if (lesson_ != nullptr && !last()) enter(place_ + 1, client, view);
}

void LessonPlayer::back(SessionClient& client, const ViewSettings& view) {
    if (lesson_ != nullptr && !first()) enter(place_ - 1, client, view);
}

const Lesson* LessonPlayer::next_lesson() const {
    const std::span<const Lesson> all = lessons();
    const auto here = std::find_if(all.begin(), all.end(), [&](const Lesson& l) { return &l == lesson_; });
    return here == all.end() || here + 1 == all.end() ? nullptr : &*(here + 1);
}

void LessonPlayer::enter(std::size_t place, SessionClient& client, const ViewSettings& view) {
    place_ = place;
    turned_ = true;
    show(client, view);
}

void LessonPlayer::show(SessionClient& client, const ViewSettings& view) {
    left_ = client.session().run;
    saved_run_.load_over(step().scene, step().recording, client, view);
}

bool LessonPlayer::take(const InputEvent& event, SessionClient& client, const ViewSettings& view) {
    if (!open_ || lesson_ == nullptr || event.kind != InputEvent::Kind::Key) return false;
    if (event.code != GLFW_KEY_PAGE_DOWN && event.code != GLFW_KEY_PAGE_UP) return false;
    if (event.repeated) return true;
    if (event.code == GLFW_KEY_PAGE_DOWN) {
        next(client, view);
    } else {
        back(client, view);
    }
    return true;
}

bool LessonPlayer::begun(const SessionClient& client) const {
    const SessionSnapshot& session = client.session();
    const Recording& recording = step().recording;
    // Turning pages quickly, another step's run may begin in between. Commands may change a setup.
    return session.run != *left_ && (!recording.commands.empty() || session.setup == recording.setup);
}

void LessonPlayer::update(SessionClient& client, ViewSettings& view) {
    saved_run_.update(client, view);
    if (lesson_ == nullptr || !left_ || !begun(client)) return;
    // A view may have nothing to show before the step's moment.
    look(step(), client, view);
    if (!client.sought()) left_.reset();
}

}  // namespace whorl::app
