#include "app/views/lane_names.h"

namespace whorl::app {

void LaneNames::update(const Setup& setup) {
    if (!names_.empty() && setup == setup_) return;
    setup_ = setup;
    // That a lane is finer is said once, by that lane, not by all others as their resolution and step.
    Setup coarse = setup;
    for (LaneSetup& lane : coarse.lanes) lane.refine = 1;
    names_ = titles(coarse);
    differences_ = differences(lane_scenes(coarse));
    for (std::size_t k = 0; k < names_.size(); ++k) {
        const LaneSetup& lane = setup.lanes[k];
        if (lane.name.empty() || lane.name == differences_[k]) differences_[k].clear();
        if (lane.refine > 1)
            differences_[k] +=
                (differences_[k].empty() ? "" : " · ") + std::to_string(lane.refine) + " × finer";
    }
}

}  // namespace whorl::app
