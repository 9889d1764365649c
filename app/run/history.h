// The measures of a run's lanes as curves, thinned so that long runs stay small.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/measure/measure.h"
#include "core/session/player.h"

namespace whorl::app {

/// The samples of one lane.
struct LaneHistory {
    std::vector<float> steps;                ///< of the session, ascending
    std::vector<float> times;                ///< at those
    std::vector<std::vector<float>> curves;  ///< of each measure, in the list's order
    Measures last;                           ///< of the last step, thinned or not

    std::span<const float> of(const Measure& measure) const;
    /// The median of a measure's last `count` samples; NaN where there are none.
    double median(const Measure& measure, std::size_t count) const;
};

/// Curves of at most `capacity` samples a lane over steps: when they are full, every other sample goes and
/// only half as many come in from then on. Lanes are known by Session::id; one that is added later begins
/// later. Where the measures begin again at an earlier step, what came after it goes.
class History {
  public:
    static constexpr std::size_t capacity = 8192;

    /// @param new_run  whether the rows begin another run, so that the older ones go
    void take(std::span<const StepMeasures> rows, bool new_run);

    /// What is known of a lane; nothing where it has not been measured.
    const LaneHistory& lane(int id) const;

  private:
    void truncate(long step);
    void add(LaneHistory& lane, long step, const Measures& measured) const;
    void thin();

    std::map<int, LaneHistory> lanes_;
    long stride_ = 1;  ///< steps between the samples that are kept
    long reached_ = -1;
};

}  // namespace whorl::app
