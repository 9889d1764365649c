#include "app/run/saved_run.h"

#include <utility>

namespace whorl::app {

SavedView save_view(const RunControl& run, const ViewSettings& view) {
    return {view.shown, view.difference, view.compare, view.wipe, view.window, run.selected(), run.other()};
}

void restore_view(const SavedView& saved, RunControl& run, ViewSettings& view) {
    view.shown = saved.shown;
    view.difference = saved.difference;
    view.compare = saved.compare;
    view.wipe = saved.wipe;
    view.window = saved.window;
    const std::size_t lanes = run.session().lanes.size();
    if (saved.other < lanes) run.select(saved.other);
    if (saved.selected < lanes) run.select(saved.selected);
}

void SavedRun::load_over(std::string_view name, const Recording& recording, RunControl& run,
                         const ViewSettings& view) {
    wanted_ = false;
    const bool own = run.loads() != own_load_;
    // One that is still on its way back has not all of itself on screen yet.
    const bool on_its_way = returning_ && run.loads() == returning_->load;
    if (on_its_way) {
        saved_ = std::move(returning_->saved);
    } else if (own) {
        saved_ = Entry{run.loaded(),
                       run.seek_target().value_or(run.session().step),
                       run.playing(),
                       save_view(run, view),
                       {}};
    }
    returning_.reset();
    run.play(false);
    run.load(name, recording, own && !on_its_way);
    own_load_ = run.loads();
}

void SavedRun::give_back(RunControl& run) {
    if (holds(run)) {
        wanted_ = true;
    } else {
        saved_.reset();
    }
}

void SavedRun::update(RunControl& run, ViewSettings& view) {
    take(run);
    if (wanted_ && !holds(run)) {
        wanted_ = false;
        saved_.reset();
    }
    if (wanted_ && saved_->recording) {
        wanted_ = false;
        run.play(false);
        run.load(saved_->name, *saved_->recording);
        returning_ = Returning{*std::exchange(saved_, {}), run.loads(), run.session().run};
    }
    if (returning_) follow(run, view);
}

/// Takes the run from the player once it has handed it over.
void SavedRun::take(RunControl& run) {
    const std::unique_ptr<StashedRun> before = run.take_stash();
    if (!before || !saved_) return;
    if (before->complete) {
        saved_->recording = std::move(before->recording);
        return;
    }
    saved_.reset();
    run.notifications().warn(
        "More was done in your run than a recording holds: it cannot be brought back after the lessons");
}

void SavedRun::follow(RunControl& run, ViewSettings& view) {
    if (run.loads() != returning_->load) return returning_.reset();
    if (run.session().run == returning_->left) return;
    const Entry& saved = returning_->saved;
    if (!std::exchange(returning_->begun, true)) run.seek(saved.step);
    // A view may have nothing to show before the run stands where it stood.
    restore_view(saved.view, run, view);
    if (run.seek_target()) return;
    run.play(saved.playing);
    returning_.reset();
}

}  // namespace whorl::app
