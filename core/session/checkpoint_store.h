// Checkpoints of a run that are kept, so that going back need not begin at the start.
#pragma once

#include <cstddef>
#include <map>

#include "core/session/lane.h"
#include "core/session/setup.h"

namespace whorl {

/// A session at the end of a step, before the commands of that step.
struct SessionCheckpoint {
    double time = 0;
    std::size_t acted = 0;  ///< commands of the recording that had acted
    int next_id = 0;        ///< of a lane that is added
    Setup setup;            ///< scene and lanes as they were set by then
    std::vector<int> ids;   ///< of the lanes
    std::vector<LaneCheckpoint> lanes;

    std::size_t bytes() const;
};

/// Keeps checkpoints at even distances, which double when the memory limit is reached. The start is not among
/// them: it is made from the setup.
class CheckpointStore {
  public:
    explicit CheckpointStore(std::size_t limit_bytes) : limit_(limit_bytes) {}

    /// Whether a checkpoint at `step` should be kept.
    bool wants(long step) const { return step > 0 && step % stride_ == 0 && !checkpoints_.contains(step); }
    void keep(long step, SessionCheckpoint checkpoint);
    /// The last checkpoint kept at or before `step`, and its step; null where there is none.
    std::pair<long, const SessionCheckpoint*> before(long step) const;
    /// Forgets checkpoints later than `step`.
    void forget_after(long step);
    void clear();

    std::size_t bytes() const { return bytes_; }

  private:
    void thin();

    std::size_t limit_;
    std::size_t bytes_ = 0;
    long stride_ = first_stride;
    std::map<long, SessionCheckpoint> checkpoints_;

    static constexpr long first_stride = 10;
};

}  // namespace whorl
