#include "app/run/saved_run.h"

#include <utility>

namespace whorl::app {

KeptLook look_of(const Remote& remote, const ViewState& view) {
    return {view.shown,  view.difference,   view.compare,  view.wipe,
            view.window, remote.selected(), remote.other()};
}

void look_again(const KeptLook& look, Remote& remote, ViewState& view) {
    view.shown = look.shown;
    view.difference = look.difference;
    view.compare = look.compare;
    view.wipe = look.wipe;
    view.window = look.window;
    const std::size_t lanes = remote.session().lanes.size();
    if (look.other < lanes) remote.select(look.other);
    if (look.selected < lanes) remote.select(look.selected);
}

void KeptRun::load_over(std::string_view name, const Recording& recording, Remote& remote,
                        const ViewState& view) {
    wanted_ = false;
    const bool own = remote.loads() != own_load_;
    // One that is still on its way back has not all of itself on screen yet.
    const bool on_its_way = returning_ && remote.loads() == returning_->load;
    if (on_its_way) {
        kept_ = std::move(returning_->kept);
    } else if (own) {
        kept_ = Kept{remote.loaded(),
                     remote.sought().value_or(remote.session().step),
                     remote.playing(),
                     look_of(remote, view),
                     {}};
    }
    returning_.reset();
    remote.play(false);
    remote.load(name, recording, own && !on_its_way);
    own_load_ = remote.loads();
}

void KeptRun::give_back(Remote& remote) {
    if (keeps(remote)) {
        wanted_ = true;
    } else {
        kept_.reset();
    }
}

void KeptRun::update(Remote& remote, ViewState& view) {
    take(remote);
    if (wanted_ && !keeps(remote)) {
        wanted_ = false;
        kept_.reset();
    }
    if (wanted_ && kept_->recording) {
        wanted_ = false;
        remote.play(false);
        remote.load(kept_->name, *kept_->recording);
        returning_ = Returning{*std::exchange(kept_, {}), remote.loads(), remote.session().run};
    }
    if (returning_) follow(remote, view);
}

/// Takes the run from the player once it has handed it over.
void KeptRun::take(Remote& remote) {
    const std::unique_ptr<SetAside> before = remote.take_set_aside();
    if (!before || !kept_) return;
    if (before->complete) {
        kept_->recording = std::move(before->recording);
        return;
    }
    kept_.reset();
    remote.notices().warn(
        "More was done in your run than a recording holds: it cannot be brought back after the lessons");
}

void KeptRun::follow(Remote& remote, ViewState& view) {
    if (remote.loads() != returning_->load) return returning_.reset();
    if (remote.session().run == returning_->left) return;
    const Kept& kept = returning_->kept;
    if (!std::exchange(returning_->begun, true)) remote.seek(kept.step);
    // A view may have nothing to show before the run stands where it stood.
    look_again(kept.look, remote, view);
    if (remote.sought()) return;
    remote.play(kept.playing);
    returning_.reset();
}

}  // namespace whorl::app
