// Steps a scene on a thread of its own, so that a window never waits for a step.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/session/snapshot.h"

namespace whorl {

/// How fast to play.
struct Pace {
    int steps_per_frame = 1;
    bool unlimited = false;  ///< as fast as it can
};

/// A session that plays in the background. All functions may be called from one other thread, and none of
/// them waits for a step. Commands act before the next step, or at once while paused.
class Player {
  public:
    /// @param threads as Pool takes them
    /// @throws InputError if the scene's choices do not go together
    Player(Scene scene, int threads);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    void play(bool playing);
    bool playing() const;
    void set_pace(Pace pace);
    /// One step, then pause.
    void step_once();
    void push(Command command);
    /// Throws the present run away and begins another scene.  @throws InputError, with nothing changed
    void load(Scene scene);

    /// Called once a frame: allows the pace's steps to be taken until the next call.
    void begin_frame();

    /// The newest finished state. The reference holds until the next call.
    const Snapshot& newest();
    /// Appends the measures of all steps since the last call, of the newest run.
    /// @return true if a new run began, so that older measures belong to another one
    bool take_measures(std::vector<Measures>& out);
    /// The last command that could not be taken, once; empty otherwise.
    std::string take_complaint();
    /// Steps finished in a second, over the last half of one.
    double steps_per_second() const;

  private:
    using Lock = std::unique_lock<std::mutex>;
    enum class Event { Stepped, Edited, Began, Failed };

    void work(const std::stop_token& stop);
    // Each begins and ends with the lock held, and lets go of it while it computes.
    void begin(Lock& lock);
    void act(Lock& lock);
    void step(Lock& lock);
    void publish(Lock& lock, Event event);
    bool wants_step() const { return single_ > 0 || (playing_ && (pace_.unlimited || allowed_ > 0)); }

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    // Guarded by mutex_.
    bool playing_ = false;
    Pace pace_;
    int allowed_ = 0;  ///< steps that the window's frames have granted
    int single_ = 0;   ///< steps asked for one by one
    std::deque<Command> commands_;
    std::optional<Scene> next_scene_;
    std::vector<Measures> measures_;
    bool new_run_ = true;
    std::string complaint_;
    int newest_ = 0, shown_ = 1, spare_ = 2;  ///< places in snapshots_
    bool fresh_ = false;                      ///< the newest has not been taken; else it is the shown one
    std::deque<double> finished_;             ///< times at which steps ended, seconds
    Snapshot snapshots_[3];

    // The worker's own.
    Pool pool_;
    std::optional<Lane> lane_;
    std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace whorl
