#include "app/run/saved_run.h"

#include <utility>

namespace whorl::app {

KeptLook look_of(const SessionClient& client, const ViewState& view) {
    return {view.shown,  view.difference,   view.compare,  view.wipe,
            view.window, client.selected(), client.other()};
}

void look_again(const KeptLook& look, SessionClient& client, ViewState& view) {
    view.shown = look.shown;
    view.difference = look.difference;
    view.compare = look.compare;
    view.wipe = look.wipe;
    view.window = look.window;
    const std::size_t lanes = client.session().lanes.size();
    if (look.other < lanes) client.select(look.other);
    if (look.selected < lanes) client.select(look.selected);
}

void KeptRun::load_over(std::string_view name, const Recording& recording, SessionClient& client,
                        const ViewState& view) {
    wanted_ = false;
    const bool own = client.loads() != own_load_;
    // One that is still on its way back has not all of itself on screen yet.
    const bool on_its_way = returning_ && client.loads() == returning_->load;
    if (on_its_way) {
        kept_ = std::move(returning_->kept);
    } else if (own) {
        kept_ = Kept{client.loaded(),
                     client.sought().value_or(client.session().step),
                     client.playing(),
                     look_of(client, view),
                     {}};
    }
    returning_.reset();
    client.play(false);
    client.load(name, recording, own && !on_its_way);
    own_load_ = client.loads();
}

void KeptRun::give_back(SessionClient& client) {
    if (keeps(client)) {
        wanted_ = true;
    } else {
        kept_.reset();
    }
}

void KeptRun::update(SessionClient& client, ViewState& view) {
    take(client);
    if (wanted_ && !keeps(client)) {
        wanted_ = false;
        kept_.reset();
    }
    if (wanted_ && kept_->recording) {
        wanted_ = false;
        client.play(false);
        client.load(kept_->name, *kept_->recording);
        returning_ = Returning{*std::exchange(kept_, {}), client.loads(), client.session().run};
    }
    if (returning_) follow(client, view);
}

/// Takes the run from the player once it has handed it over.
void KeptRun::take(SessionClient& client) {
    const std::unique_ptr<SetAside> before = client.take_set_aside();
    if (!before || !kept_) return;
    if (before->complete) {
        kept_->recording = std::move(before->recording);
        return;
    }
    kept_.reset();
    client.notifications().warn(
        "More was done in your run than a recording holds: it cannot be brought back after the lessons");
}

void KeptRun::follow(SessionClient& client, ViewState& view) {
    if (client.loads() != returning_->load) return returning_.reset();
    if (client.session().run == returning_->left) return;
    const Kept& kept = returning_->kept;
    if (!std::exchange(returning_->begun, true)) client.seek(kept.step);
    // A view may have nothing to show before the run stands where it stood.
    look_again(kept.look, client, view);
    if (client.sought()) return;
    client.play(kept.playing);
    returning_.reset();
}

}  // namespace whorl::app
