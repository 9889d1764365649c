// Plays a session on a thread of its own, so that a window never waits for a step.
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

/// The measures of all lanes at one step.
struct StepMeasures {
    long step = 0;
    std::vector<int> ids;  ///< see Session::id
    std::vector<Measures> lanes;
};

/// A moment on screen and the run that leads to it.
struct Saved {
    SessionSnapshot snapshot;
    Recording recording;
    bool complete = true;  ///< whether the recording holds all of the run
};

/// A run that another one has taken the place of, up to the last step that it had reached.
struct StashedRun {
    Recording recording;
    bool complete = true;  ///< whether the recording holds all of the run
};

/// A session that plays in the background. All functions may be called from one other thread, and none of
/// them waits for a step. Commands act before the next step, or at once while paused.
class Player {
  public:
    /// Goes to the recording's step at once.
    /// @param threads as Pool takes them
    /// @throws InputError if the setup's choices do not go together
    Player(Recording recording, int threads);
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    void play(bool playing);
    bool playing() const;
    void set_pace(Pace pace);
    /// One step, then pause.
    void step_once();
    /// @return a ticket: the command has acted, or was refused, in snapshots whose `taken` has reached it
    std::uint64_t push(Command command);
    /// Throws the present run away and begins another one, at its recording's step.
    /// @param stash  hands the present run over instead; take_stash has it once the other one has
    /// begun
    /// @throws InputError, with nothing changed
    void load(Recording recording, bool stash = false);
    std::unique_ptr<StashedRun> take_stash();
    /// Goes to a step of the run that has been reached before, and pauses.
    void seek(long step);
    /// The step that is on its way to be reached, if any. Where there is none, the newest snapshot shows what
    /// was sought last.
    std::optional<long> seek_target() const;

    /// Called once a frame: allows the pace's steps to be taken until the next call.
    void begin_frame();

    /// The newest finished state. The reference holds until the next call.
    const SessionSnapshot& newest();
    /// Appends the measures of all steps since the last call, of the newest run; after a seek they begin
    /// again at an earlier step.
    /// @return true if a new run began, so that older measures belong to another one
    bool take_measures(std::vector<StepMeasures>& out);
    /// The last command that could not be taken, once; empty otherwise.
    std::string take_error();
    /// What snapshots and measures tell beside the fields, from a snapshot that is soon to come. While paused
    /// it tells of the step that is on screen, which is taken once more where nothing is kept of it.
    void watch(const Watch& watch);
    /// Asks for the present moment and the run up to it; take_saved has it soon after.
    void save();
    std::unique_ptr<Saved> take_saved();
    /// Steps finished in a second, over the last half of one.
    double steps_per_second() const;

  private:
    using Lock = std::unique_lock<std::mutex>;
    enum class Event { Stepped, Edited, Began };
    static constexpr double rate_window = 0.5;  ///< seconds over which steps are counted

    static double now();  ///< seconds

    void work(const std::stop_token& stop);
    // Each begins and ends with the lock held, and lets go of it while it computes.
    void begin(Lock& lock);
    void act(Lock& lock);
    void step(Lock& lock);
    void rewind(Lock& lock);
    void finish_seek(Lock& lock);
    /// Whether the moment was restored, so that the step that led to it has to be taken again to be watched.
    bool retakes() const { return restored_ && session_->step_number() > 0 && session_->complete(); }
    void save_state(Lock& lock);
    void refresh(Lock& lock);
    void publish(Lock& lock, Event event);
    void note_step();
    bool wants_step() const {
        return target_ || single_ > 0 || (playing_ && (pace_.unlimited || allowed_ > 0));
    }
    bool wants_work() const {
        return next_ || !commands_.empty() || rewind_to_ || save_ || refresh_ || wants_step();
    }

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    // Guarded by mutex_.
    bool playing_ = false;
    Pace pace_;
    int allowed_ = 0;  ///< steps that the window's frames have granted
    int single_ = 0;   ///< steps asked for one by one
    std::deque<Command> commands_;
    std::uint64_t pushed_ = 0;  ///< commands so far
    std::uint64_t taken_ = 0;   ///< of them, those that have acted or were refused or dropped
    std::optional<Recording> next_;
    bool stashes_ = false;  ///< next_ does, or one that it took the place of
    std::unique_ptr<StashedRun> stash_;
    std::optional<long> loading_;    ///< the step of a loaded run that has not begun yet
    std::optional<long> rewind_to_;  ///< a seek that has not begun yet
    std::optional<long> target_;     ///< the step of the seek that is under way
    std::vector<StepMeasures> measures_;
    bool new_run_ = true;
    std::string error_;
    bool save_ = false;
    Watch watch_;
    bool refresh_ = false;  ///< what is watched has changed
    std::unique_ptr<Saved> saved_;
    int newest_ = 0, shown_ = 1, spare_ = 2;  ///< places in snapshots_
    bool fresh_ = false;                      ///< the newest has not been taken; else it is the shown one
    std::deque<double> finished_;             ///< times at which steps ended, seconds
    SessionSnapshot snapshots_[3];

    // The worker's own.
    Pool pool_;
    std::optional<Session> session_;
    bool restored_ = false;  ///< no step has been taken since session_ was rewound
    double published_ = 0;   ///< time of the last snapshot, seconds
    std::jthread thread_;    ///< last, so that it ends before what it uses
};

}  // namespace whorl
