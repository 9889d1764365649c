#include "app/lessons/lesson_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace whorl::app {

void LessonRun::enter(const LessonStep& step) {
    Recording recording = step.recording;
    recording.step = 0;
    std::vector<const Measure*> claimed;
    for (const Claim& claim : step.claims) claimed.push_back(claim.measure);
    const bool known = session_ && recording == begun_ &&
                       std::all_of(claimed.begin(), claimed.end(), [&](const Measure* measure) {
                           return !measure->on_demand() || session_->is_asked(*measure);
                       });
    if (!known) {
        session_.reset();
        session_.emplace(recording, pool_);
        session_->ask(claimed);
        begun_ = std::move(recording);
        measures_.clear();
    }
    long last = step.recording.step;
    for (const Claim& claim : step.claims) last = std::max(last, claim.last_step());
    run_to(last);
}

void LessonRun::run_to(long step) {
    const auto keep = [&] {
        if (measures_.size() > static_cast<std::size_t>(session_->step_number())) return;
        std::vector<Measures>& now = measures_.emplace_back();
        for (std::size_t k = 0; k < session_->lane_count(); ++k) {
            now.push_back(session_->measures(k));
            if (const auto& failure = session_->lane(k).failure())
                throw InputError("lane " + std::to_string(k + 1) + " stopped: " + *failure);
        }
    };
    keep();
    while (session_->step_number() < step) {
        session_->step();
        keep();
    }
}

double LessonRun::measure(const Measure& measure, const LaneAtStep& place) const {
    const auto at = [&](std::size_t step) {
        const std::vector<Measures>& lanes = measures_[step];
        // A recorded command may have taken the lane away.
        return place.lane < lanes.size() ? measure.of(lanes[place.lane])
                                         : std::numeric_limits<double>::quiet_NaN();
    };
    const auto last = static_cast<std::size_t>(place.step);
    if (measure.mean != Mean::OverSteps) return at(last);
    double sum = 0, steps = 0;
    for (std::size_t step = 1; step <= last; ++step) {
        if (!std::isfinite(at(step))) continue;
        sum += at(step);
        steps += 1;
    }
    return sum / steps;
}

double LessonRun::measure(const Claim& claim) const {
    const double value = measure(*claim.measure, claim.place);
    return claim.over ? value / measure(*claim.measure, *claim.over) : value;
}

SessionSnapshot LessonRun::look(const LessonStep& step) {
    if (session_->step_number() > step.recording.step) session_->rewind(step.recording.step);
    run_to(step.recording.step);
    SessionSnapshot snapshot;
    take_shown(*session_, *step.view, snapshot, pool_, snapshot);
    return snapshot;
}

}  // namespace whorl::app
