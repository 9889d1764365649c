// Lanes stepped in lock-step on the same commands, all of which are recorded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/inspect/limiter_masks.h"
#include "core/measure/average.h"
#include "core/measure/measure.h"
#include "core/session/checkpoint_store.h"
#include "core/session/recording.h"

namespace whorl {

/// A run of one to six lanes of a scene. Its steps are of the scene's Δt; a lane with another Δt takes as
/// many of its own as bring it to the same time, so that all lanes show the same checkpoint. The same
/// recording gives the same bits, with any number of threads.
class Session {
  public:
    /// Memory that the checkpoints to go back to may take.
    static constexpr std::size_t checkpoints_limit = std::size_t{512} << 20;

    /// Stands at step 0 of a recording, whose commands act when their step is reached.
    /// @param pool  does the work; must outlive the session
    /// @throws InputError if the setup's choices do not go together
    Session(Recording recording, Pool& pool, std::size_t limit_bytes = checkpoints_limit);

    /// One step of every lane that runs, then the commands recorded for it.
    /// @throws InputError if a recorded command cannot act; the session then stands behind it
    void step();
    /// Acts now and is recorded; what was recorded for later steps is dropped. A Restart drops the recording
    /// too.
    /// @throws InputError, with nothing changed
    void apply(const Command& command);
    /// Back to the last checkpoint that is kept at or before `step`. Step on from there to reach it.
    /// @throws InputError as step() does
    void rewind(long step);

    /// Whether steps note where limiters act. Goes for the last step at once.
    void watch_limiters(bool watch);
    bool watches_limiters() const { return watches_limiters_; }
    /// Has steps work out what is asked for of the measures that are on demand; others need no asking. Goes
    /// for the present state at once.
    void ask(std::span<const Measure* const> asked);
    bool is_asked(const Measure& measure) const;

    long step_number() const { return step_; }
    double time() const { return time_; }
    /// The furthest step that has been reached, or that the recording goes to.
    long last_step() const { return last_step_; }
    /// The run up to now: its commands that have acted.
    Recording recording() const;
    /// All of the run, up to its last step, with the commands that have not acted again since a rewind.
    Recording whole_recording() const;
    /// Whether all commands of the run are in the recording.
    bool complete() const { return complete_; }

    /// The scene and the lanes as they are set now.
    const Setup& setup() const { return setup_; }
    std::size_t lane_count() const { return lanes_.size(); }
    const Lane& lane(std::size_t k) const { return *lanes_[k].lane; }
    /// A number that stays with a lane wherever it moves.
    int id(std::size_t k) const { return lanes_[k].id; }
    /// Where limiters acted in a lane's last step; null where that is not watched or not known.
    const LimiterMasks* limits(std::size_t k) const;
    /// Of a lane's present state; its errors are against the exact solution, or else against the reference.
    const Measures& measures(std::size_t k) const { return lanes_[k].measures; }
    /// Whether any lane can be stepped on.
    bool running() const;
    /// A number made from every bit of the lanes' fields and times: equal runs have equal ones.
    std::uint64_t digest() const;

  private:
    struct LaneSlot {
        std::unique_ptr<Lane> lane;
        int id = 0;
        Measures measures;
        std::optional<LimiterMasks> limits{};
        std::vector<Reduced> reduced{};  ///< of the last step
    };

    void begin();
    std::string act_recorded();
    void act(const Command& command);
    void set(const Setup& setup);
    void arrange(const Arrange& arrange);
    void measure();
    void observe();
    void note_limiters(LaneSlot& slot);
    bool marks_limiters() const;
    void measure_against(const Simulation& reference);
    SessionCheckpoint checkpoint() const;

    Pool* pool_;
    Recording recorded_;
    std::size_t acted_ = 0;  ///< commands of recorded_ that have acted
    bool complete_ = true;
    Setup setup_;
    long step_ = 0, last_step_ = 0;
    double time_ = 0;
    bool watches_limiters_ = false;
    std::vector<const Measure*> asked_;  ///< of those on demand
    int next_id_ = 0;
    std::vector<LaneSlot> lanes_;
    CheckpointStore kept_;
    Reducer reducer_;
    Averager averager_;
    Field averaged_;  ///< the reference's density on a lane's grid
};

}  // namespace whorl
