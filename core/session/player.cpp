#include "core/session/player.h"

#include <algorithm>
#include <chrono>

#include "core/scene/error.h"

namespace whorl {
namespace {

constexpr double rate_window = 0.5;  // seconds over which steps are counted

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Player::Player(Scene scene, int threads) : pool_(threads), lane_(std::in_place, std::move(scene), pool_) {
    take_snapshot(*lane_, pool_, snapshots_[newest_]);
    measures_.push_back(snapshots_[newest_].measures);
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

void Player::push(Command command) {
    const std::lock_guard lock(mutex_);
    commands_.push_back(std::move(command));
    wake_.notify_all();
}

void Player::load(Scene scene) {
    const std::string reason = conflict(scene);
    if (!reason.empty()) throw InputError(reason);
    const std::lock_guard lock(mutex_);
    next_scene_ = std::move(scene);
    commands_.clear();
    single_ = 0;
    wake_.notify_all();
}

void Player::begin_frame() {
    const std::lock_guard lock(mutex_);
    // What a slow step left over is not made up for: the run is slower then, not the window.
    allowed_ = std::min(allowed_ + pace_.steps_per_frame, pace_.steps_per_frame);
    wake_.notify_all();
}

const Snapshot& Player::newest() {
    const std::lock_guard lock(mutex_);
    if (fresh_) {
        std::swap(newest_, shown_);
        fresh_ = false;
    }
    return snapshots_[shown_];
}

bool Player::take_measures(std::vector<Measures>& out) {
    const std::lock_guard lock(mutex_);
    const bool fresh_run = std::exchange(new_run_, false);
    if (fresh_run) out.clear();
    out.insert(out.end(), measures_.begin(), measures_.end());
    measures_.clear();
    return fresh_run;
}

std::string Player::take_complaint() {
    const std::lock_guard lock(mutex_);
    return std::exchange(complaint_, {});
}

double Player::steps_per_second() const {
    const std::lock_guard lock(mutex_);
    const double since = now() - rate_window;
    return static_cast<double>(
               std::count_if(finished_.begin(), finished_.end(), [&](double t) { return t > since; })) /
           rate_window;
}

void Player::work(const std::stop_token& stop) {
    flush_denormals();
    Lock lock(mutex_);
    while (!stop.stop_requested()) {
        if (next_scene_) {
            begin(lock);
        } else if (!commands_.empty()) {
            act(lock);
        } else if (wants_step()) {
            step(lock);
        } else {
            wake_.wait(lock, stop, [&] { return next_scene_ || !commands_.empty() || wants_step(); });
        }
    }
}

void Player::begin(Lock& lock) {
    Scene scene = std::move(*next_scene_);
    next_scene_.reset();
    lock.unlock();
    lane_.emplace(std::move(scene), pool_);
    lock.lock();
    publish(lock, Event::Began);
}

void Player::act(Lock& lock) {
    std::deque<Command> commands;
    commands.swap(commands_);
    lock.unlock();
    std::string complaint;
    bool began = false;
    for (const Command& command : commands) {
        try {
            lane_->apply(command);
        } catch (const InputError& e) {
            complaint = e.what();
        }
        began = began || std::holds_alternative<Restart>(command);
    }
    lock.lock();
    if (!complaint.empty()) complaint_ = complaint;
    if (began) {
        publish(lock, Event::Began);
    } else if (!wants_step()) {
        publish(lock, lane_->failure() ? Event::Failed : Event::Edited);
    }
}

void Player::step(Lock& lock) {
    if (single_ > 0) {
        --single_;
    } else if (!pace_.unlimited) {
        --allowed_;
    }
    lock.unlock();
    const bool sound = lane_->step();
    lock.lock();
    if (sound) {
        const double t = now();
        finished_.push_back(t);
        while (finished_.front() < t - rate_window) finished_.pop_front();
    } else {
        playing_ = false;
    }
    publish(lock, sound ? Event::Stepped : Event::Failed);
}

/// Writes the spare snapshot without the lock, then makes it the newest.
void Player::publish(Lock& lock, Event event) {
    Snapshot& out = snapshots_[spare_];
    const Snapshot& last = snapshots_[fresh_ ? newest_ : shown_];
    lock.unlock();
    if (event == Event::Failed) {
        out = last;  // the last sound fields stay on screen
        out.failure = lane_->failure();
    } else {
        take_snapshot(*lane_, pool_, out);
        out.run = last.run + (event == Event::Began ? 1 : 0);
    }
    out.serial = last.serial + 1;
    lock.lock();
    if (event == Event::Began) {
        measures_.clear();
        new_run_ = true;
    }
    if (event == Event::Began || event == Event::Stepped) measures_.push_back(out.measures);
    std::swap(newest_, spare_);
    fresh_ = true;
}

}  // namespace whorl
