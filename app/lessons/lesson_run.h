// Runs a lesson's steps without a window, and measures what they claim.
#pragma once

#include <optional>

#include "app/lessons/lesson.h"
#include "core/session/session.h"
#include "core/session/snapshot.h"

namespace whorl::app {

/// The runs of a lesson's steps, one after the other. A step that changes nothing of the run before goes on
/// with it.
class LessonRun {
  public:
    /// @param pool  does the work; must outlive this
    explicit LessonRun(Pool& pool) : pool_(pool) {}

    /// Goes as far as a step needs.
    /// @throws InputError as Session does, and if a lane stops
    void enter(const LessonStep& step);
    /// What a claim of the entered step speaks of; not a number where nothing is known.
    double measure(const Claim& claim) const;
    /// The entered step's moment, to be drawn.
    SessionSnapshot look(const LessonStep& step);

  private:
    double measure(const Measure& measure, const LaneAtStep& place) const;
    void run_to(long step);

    Pool& pool_;
    std::optional<Session> session_;
    Recording begun_;                              ///< what session_ began with
    std::vector<std::vector<Measures>> measures_;  ///< of each step and lane
};

}  // namespace whorl::app
