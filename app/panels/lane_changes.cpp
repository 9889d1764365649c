#include "app/panels/lane_changes.h"

#include <algorithm>
#include <utility>

namespace whorl::app {

void add_lane(Arrange& lanes, std::size_t place, LaneSetup lane, bool as_reference) {
    const auto next = static_cast<std::ptrdiff_t>(place) + 1;
    const auto at = static_cast<int>(place);
    lanes.lanes.insert(lanes.lanes.begin() + next, std::move(lane));
    lanes.from.insert(lanes.from.begin() + next, at);
    if (as_reference) {
        lanes.reference = at + 1;
    } else if (lanes.reference > at) {
        ++lanes.reference;
    }
}

void remove_lane(Arrange& lanes, std::size_t place) {
    const auto at = static_cast<int>(place);
    lanes.lanes.erase(lanes.lanes.begin() + at);
    lanes.from.erase(lanes.from.begin() + at);
    if (lanes.reference == at) lanes.reference = no_reference;
    if (lanes.reference > at) --lanes.reference;
}

void move_lane(Arrange& lanes, std::size_t place, int by) {
    const auto at = static_cast<int>(place);
    const int to = at + by;
    std::swap(lanes.lanes[place], lanes.lanes[static_cast<std::size_t>(to)]);
    std::swap(lanes.from[place], lanes.from[static_cast<std::size_t>(to)]);
    if (lanes.reference == at) {
        lanes.reference = to;
    } else if (lanes.reference == to) {
        lanes.reference = at;
    }
}

LaneSetup copy_of(const LaneSetup& lane, const std::vector<LaneSetup>& lanes) {
    LaneSetup copy = lane;
    if (copy.name.empty()) return copy;
    const auto taken = [&](const std::string& name) {
        return std::any_of(lanes.begin(), lanes.end(), [&](const LaneSetup& l) { return l.name == name; });
    };
    for (int number = 2; taken(copy.name); ++number)
        copy.name = lane.name + " (" + std::to_string(number) + ")";
    return copy;
}

}  // namespace whorl::app
