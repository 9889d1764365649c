#include "core/session/checkpoint_store.h"

#include <iterator>

namespace whorl {
std::size_t SessionCheckpoint::bytes() const {
    std::size_t sum = sizeof(SessionCheckpoint);
    for (const LaneCheckpoint& lane : lanes) {
        const State& s = lane.simulation.state;
        for_each_field(s, [&](FieldId, const Field& field) { sum += sizeof(Real) * field.memory().size(); });
        sum += sizeof(double) * lane.simulation.projection.pressure.size();
        sum += lane.simulation.advection.bytes();
        sum += sizeof(LaneCheckpoint) + s.boundary.bytes();
    }
    return sum;
}

void CheckpointStore::keep(long step, SessionCheckpoint checkpoint) {
    bytes_ += checkpoint.bytes();
    checkpoints_.emplace(step, std::move(checkpoint));
    while (bytes_ > limit_) thin();
}

std::pair<long, const SessionCheckpoint*> CheckpointStore::before(long step) const {
    const auto after = checkpoints_.upper_bound(step);
    if (after == checkpoints_.begin()) return {0, nullptr};
    return {std::prev(after)->first, &std::prev(after)->second};
}

void CheckpointStore::forget_after(long step) {
    for (auto it = checkpoints_.upper_bound(step); it != checkpoints_.end(); it = checkpoints_.erase(it))
        bytes_ -= it->second.bytes();
}

void CheckpointStore::clear() {
    checkpoints_.clear();
    bytes_ = 0;
    stride_ = first_stride;
}

void CheckpointStore::thin() {
    stride_ *= 2;
    for (auto it = checkpoints_.begin(); it != checkpoints_.end();) {
        if (it->first % stride_ == 0) {
            ++it;
        } else {
            bytes_ -= it->second.bytes();
            it = checkpoints_.erase(it);
        }
    }
}

}  // namespace whorl
