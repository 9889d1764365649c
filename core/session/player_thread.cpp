// What a player does on its own thread.
#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/session/player.h"

namespace whorl {
namespace {

constexpr double seek_frame = 0.03;  // seconds between the snapshots on the way of a seek

}  // namespace

double Player::now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void Player::work(const std::stop_token& stop) {
    flush_denormals();
    Lock lock(mutex_);
    while (!stop.stop_requested()) {
        if (next_) {
            begin(lock);
        } else if (rewind_to_) {
            rewind(lock);
        } else if (!commands_.empty()) {
            act(lock);
        } else if (save_) {
            save_state(lock);
        } else if (refresh_) {
            refresh(lock);
        } else if (wants_step()) {
            step(lock);
        } else {
            wake_.wait(lock, stop, [&] { return wants_work(); });
        }
    }
}

void Player::begin(Lock& lock) {
    Recording recording = std::move(*next_);
    next_.reset();
    const Watch watched = watch_;
    const bool stashes = std::exchange(stashes_, false);
    lock.unlock();
    std::string error;
    std::unique_ptr<StashedRun> before;
    try {
        Session session(std::move(recording), pool_);
        session.watch_limiters(watched.limiters);
        session.ask(watched.measures);
        if (stashes)
            before =
                std::make_unique<StashedRun>(StashedRun{session_->whole_recording(), session_->complete()});
        session_.emplace(std::move(session));
        restored_ = false;
    } catch (const InputError& e) {
        error = e.what();
    }
    lock.lock();
    if (error.empty()) {
        if (before) stash_ = std::move(before);
        target_.reset();
        if (session_->last_step() > 0) target_ = session_->last_step();
        publish(lock, Event::Began);
    } else {
        error_ = error;
    }
    // Unless another one has been loaded meanwhile.
    if (!next_) loading_.reset();
}

void Player::act(Lock& lock) {
    std::deque<Command> commands;
    commands.swap(commands_);
    taken_ += commands.size();
    target_.reset();  // who acts on the way of a seek goes on from there
    lock.unlock();
    std::string error;
    bool began = false;
    for (const Command& command : commands) {
        try {
            session_->apply(command);
        } catch (const InputError& e) {
            error = e.what();
        }
        began = began || std::holds_alternative<Restart>(command);
    }
    lock.lock();
    if (!error.empty()) error_ = error;
    if (began) {
        publish(lock, Event::Began);
    } else if (!wants_step()) {
        publish(lock, Event::Edited);
    }
}

void Player::rewind(Lock& lock) {
    const long step = std::clamp(*rewind_to_, 0L, session_->last_step());
    rewind_to_.reset();
    target_ = step;
    // What is watched is known of a step that was taken, not of a checkpoint.
    const bool retake = watch_.any() && retakes();
    // A step that lies ahead is nearer from here than from a kept checkpoint, as a rule.
    if (step > session_->step_number() || (step == session_->step_number() && !retake)) return;
    const long to = watch_.any() ? std::max(0L, step - 1) : step;
    lock.unlock();
    std::string error;
    try {
        session_->rewind(to);
    } catch (const InputError& e) {
        error = e.what();
    }
    restored_ = true;
    lock.lock();
    if (!error.empty()) error_ = error;
    note_step();
    if (session_->step_number() >= step) finish_seek(lock);
}

/// Shows the step that was sought before it says that the seek has ended.
void Player::finish_seek(Lock& lock) {
    publish(lock, Event::Edited);
    if (target_ && session_->step_number() >= *target_) target_.reset();
}

void Player::step(Lock& lock) {
    const bool seeking = target_.has_value();
    if (seeking && session_->step_number() >= *target_) return finish_seek(lock);
    if (seeking) {
        // Goes as fast as it can.
    } else if (single_ > 0) {
        --single_;
    } else if (!pace_.unlimited) {
        --allowed_;
    }
    lock.unlock();
    restored_ = false;
    std::string error;
    try {
        session_->step();
    } catch (const InputError& e) {
        error = e.what();
    }
    lock.lock();
    if (!error.empty()) error_ = error;
    const double t = now();
    finished_.push_back(t);
    while (finished_.front() < t - rate_window) finished_.pop_front();
    note_step();
    const bool stopped = !session_->running();
    if (stopped) playing_ = false;
    // On the way of a seek a snapshot now and then will do.
    if (stopped || !target_ || t > published_ + seek_frame) publish(lock, Event::Stepped);
    if (stopped) target_.reset();
}

void Player::note_step() {
    StepMeasures row;
    row.step = session_->step_number();
    for (std::size_t k = 0; k < session_->lane_count(); ++k) {
        row.ids.push_back(session_->id(k));
        row.lanes.push_back(session_->measures(k));
    }
    measures_.push_back(std::move(row));
}

void Player::save_state(Lock& lock) {
    save_ = false;
    const SessionSnapshot& last = snapshots_[fresh_ ? newest_ : shown_];
    lock.unlock();
    auto saved = std::make_unique<Saved>();
    take_snapshot(*session_, last, pool_, saved->snapshot);
    saved->snapshot.run = last.run;
    saved->snapshot.serial = last.serial;
    saved->recording = session_->recording();
    saved->recording.digest = saved->snapshot.digest();
    saved->complete = session_->complete();
    lock.lock();
    saved_ = std::move(saved);
}

void Player::refresh(Lock& lock) {
    refresh_ = false;
    const Watch watch = watch_;
    const bool on_its_way = wants_step();
    lock.unlock();
    session_->watch_limiters(watch.limiters);
    session_->ask(watch.measures);
    lock.lock();
    if (watch.any() && retakes() && !on_its_way && !rewind_to_) {
        rewind_to_ = session_->step_number();
    } else {
        publish(lock, Event::Edited);
    }
}

/// Writes the spare snapshot without the lock, then makes it the newest.
void Player::publish(Lock& lock, Event event) {
    SessionSnapshot& out = snapshots_[spare_];
    const SessionSnapshot& last = snapshots_[fresh_ ? newest_ : shown_];
    out.taken = taken_;
    const std::optional<Watch::Node> node = watch_.node;
    lock.unlock();
    take_snapshot(*session_, last, pool_, out, node);
    out.run = last.run + (event == Event::Began ? 1 : 0);
    out.serial = last.serial + 1;
    lock.lock();
    if (event == Event::Began) {
        measures_.clear();
        new_run_ = true;
        note_step();
    }
    published_ = now();
    std::swap(newest_, spare_);
    fresh_ = true;
}

}  // namespace whorl
