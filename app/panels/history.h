// The measures of a run as curves, thinned so that long runs stay small.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/session/player.h"

namespace whorl::app {

/// What is kept of every measured step.
enum class Track {
    DensityPercent,
    KineticEnergy,
    Enstrophy,
    DivergenceBefore,
    DivergenceAfter,
    ForcesMs,
    ProjectionMs,
    AdvectionMs,
    TotalMs,
    L1,
    L2,
    Linf,
    Count
};

/// Curves of at most `capacity` samples over steps: when they are full, every other sample goes and only half
/// as many come in from then on.
class History {
  public:
    static constexpr std::size_t capacity = 8192;

    History();
    /// @param new_run  whether the measures begin another run, so that the older ones go
    void take(std::span<const StepMeasures> measures, int lane, bool new_run);

    std::span<const float> steps() const { return steps_; }
    std::span<const float> of(Track track) const { return tracks_[static_cast<std::size_t>(track)]; }
    /// The last step's measures, thinned or not.
    const Measures& last() const { return last_; }

  private:
    void add(const Measures& measures);
    void thin();

    std::vector<float> steps_;
    std::array<std::vector<float>, static_cast<std::size_t>(Track::Count)> tracks_;
    long stride_ = 1;  ///< steps between the samples that are kept
    Measures last_;
};

}  // namespace whorl::app
