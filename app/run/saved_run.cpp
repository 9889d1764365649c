#include "app/run/saved_run.h"

#include <utility>

namespace whorl::app {

SavedView save_view(const SessionClient& client, const ViewSettings& view) {
    return {view.shown,  view.difference,   view.compare,  view.wipe,
            view.window, client.selected(), client.other()};
}

void restore_view(const SavedView& saved, SessionClient& client, ViewSettings& view) {
    view.shown = saved.shown;
    view.difference = saved.difference;
    view.compare = saved.compare;
    view.wipe = saved.wipe;
    view.window = saved.window;
    const std::size_t lanes = client.session().lanes.size();
    if (saved.other < lanes) client.select(saved.other);
    if (saved.selected < lanes) client.select(saved.selected);
}

void SavedRun::load_over(std::string_view name, const Recording& recording, SessionClient& client,
                         const ViewSettings& view) {
    wanted_ = false;
    const bool own = client.loads() != own_load_;
    // One that is still on its way back has not all of itself on screen yet.
    const bool on_its_way = returning_ && client.loads() == returning_->load;
    if (on_its_way) {
        saved_ = std::move(returning_->saved);
    } else if (own) {
        saved_ = Entry{client.loaded(),
                       client.sought().value_or(client.session().step),
                       client.playing(),
                       save_view(client, view),
                       {}};
    }
    returning_.reset();
    client.play(false);
    client.load(name, recording, own && !on_its_way);
    own_load_ = client.loads();
}

void SavedRun::give_back(SessionClient& client) {
    if (holds(client)) {
        wanted_ = true;
    } else {
        saved_.reset();
    }
}

void SavedRun::update(SessionClient& client, ViewSettings& view) {
    take(client);
    if (wanted_ && !holds(client)) {
        wanted_ = false;
        saved_.reset();
    }
    if (wanted_ && saved_->recording) {
        wanted_ = false;
        client.play(false);
        client.load(saved_->name, *saved_->recording);
        returning_ = Returning{*std::exchange(saved_, {}), client.loads(), client.session().run};
    }
    if (returning_) follow(client, view);
}

/// Takes the run from the player once it has handed it over.
void SavedRun::take(SessionClient& client) {
    const std::unique_ptr<SetAside> before = client.take_set_aside();
    if (!before || !saved_) return;
    if (before->complete) {
        saved_->recording = std::move(before->recording);
        return;
    }
    saved_.reset();
    client.notifications().warn(
        "More was done in your run than a recording holds: it cannot be brought back after the lessons");
}

void SavedRun::follow(SessionClient& client, ViewSettings& view) {
    if (client.loads() != returning_->load) return returning_.reset();
    if (client.session().run == returning_->left) return;
    const Entry& saved = returning_->saved;
    if (!std::exchange(returning_->begun, true)) client.seek(saved.step);
    // A view may have nothing to show before the run stands where it stood.
    restore_view(saved.view, client, view);
    if (client.sought()) return;
    client.play(saved.playing);
    returning_.reset();
}

}  // namespace whorl::app
