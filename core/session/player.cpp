// What the window asks of a player.
#include "core/session/player.h"

#include <algorithm>
#include <iterator>

namespace whorl {

Player::Player(Recording recording, int threads)
    : pool_(threads), session_(std::in_place, std::move(recording), pool_) {
    if (session_->last_step() > 0) target_ = session_->last_step();
    SessionSnapshot& first = snapshots_[newest_];
    take_snapshot(*session_, first, pool_, first);
    note_step();
    fresh_ = true;
    thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

Player::~Player() {
    thread_.request_stop();
    wake_.notify_all();
}

void Player::play(bool playing) {
    const std::lock_guard lock(mutex_);
    playing_ = playing;
    wake_.notify_all();
}

bool Player::playing() const {
    const std::lock_guard lock(mutex_);
    return playing_;
}

void Player::set_pace(Pace pace) {
    const std::lock_guard lock(mutex_);
    pace_ = pace;
    wake_.notify_all();
}

void Player::step_once() {
    const std::lock_guard lock(mutex_);
    playing_ = false;
    ++single_;
    wake_.notify_all();
}

void Player::seek(long step) {
    const std::lock_guard lock(mutex_);
    playing_ = false;
    single_ = 0;
    rewind_to_ = step;
    wake_.notify_all();
}

std::optional<long> Player::seek_target() const {
    const std::lock_guard lock(mutex_);
    if (loading_) return loading_;
    return rewind_to_ ? rewind_to_ : target_;
}

void Player::watch(const Watch& watch) {
    const std::lock_guard lock(mutex_);
    if (watch == watch_) return;
    watch_ = watch;
    refresh_ = true;
    wake_.notify_all();
}

void Player::save() {
    const std::lock_guard lock(mutex_);
    save_ = true;
    wake_.notify_all();
}

std::unique_ptr<Saved> Player::take_saved() {
    const std::lock_guard lock(mutex_);
    return std::move(saved_);
}

std::uint64_t Player::push(Command command) {
    const std::lock_guard lock(mutex_);
    commands_.push_back(std::move(command));
    wake_.notify_all();
    return ++pushed_;
}

void Player::load(Recording recording, bool stash) {
    lane_scenes(recording.setup);
    const std::lock_guard lock(mutex_);
    loading_ = recording.step;
    next_ = std::move(recording);
    stashes_ = stashes_ || stash;
    taken_ += commands_.size();
    commands_.clear();
    single_ = 0;
    rewind_to_.reset();
    target_.reset();
    wake_.notify_all();
}

std::unique_ptr<StashedRun> Player::take_stash() {
    const std::lock_guard lock(mutex_);
    return std::move(stash_);
}

void Player::begin_frame() {
    const std::lock_guard lock(mutex_);
    // What a slow step left over is not made up for: the run is slower then, not the window.
    allowed_ = std::min(allowed_ + pace_.steps_per_frame, pace_.steps_per_frame);
    wake_.notify_all();
}

const SessionSnapshot& Player::newest() {
    const std::lock_guard lock(mutex_);
    if (fresh_) {
        std::swap(newest_, shown_);
        fresh_ = false;
    }
    return snapshots_[shown_];
}

bool Player::take_measures(std::vector<StepMeasures>& out) {
    const std::lock_guard lock(mutex_);
    const bool fresh_run = std::exchange(new_run_, false);
    if (fresh_run) out.clear();
    std::move(measures_.begin(), measures_.end(), std::back_inserter(out));
    measures_.clear();
    return fresh_run;
}

std::string Player::take_error() {
    const std::lock_guard lock(mutex_);
    return std::exchange(error_, {});
}

double Player::steps_per_second() const {
    const std::lock_guard lock(mutex_);
    const double since = now() - rate_window;
    return static_cast<double>(
               std::count_if(finished_.begin(), finished_.end(), [&](double t) { return t > since; })) /
           rate_window;
}

}  // namespace whorl
