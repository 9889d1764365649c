#include "core/session/kept_moments.h"

#include <iterator>

namespace whorl {
std::size_t Moment::bytes() const {
    std::size_t sum = sizeof(Moment);
    for (const Lane::Moment& lane : lanes) {
        const State& s = lane.checkpoint.state;
        for_each_field(s, [&](FieldId, const Field& field) { sum += sizeof(Real) * field.memory().size(); });
        sum += sizeof(double) * lane.checkpoint.projection.pressure.size();
        sum += lane.checkpoint.advection.bytes();
        sum += sizeof(Lane::Moment) + s.boundary.bytes();
    }
    return sum;
}

void KeptMoments::keep(long step, Moment moment) {
    bytes_ += moment.bytes();
    moments_.emplace(step, std::move(moment));
    while (bytes_ > limit_) thin();
}

std::pair<long, const Moment*> KeptMoments::before(long step) const {
    const auto after = moments_.upper_bound(step);
    if (after == moments_.begin()) return {0, nullptr};
    return {std::prev(after)->first, &std::prev(after)->second};
}

void KeptMoments::forget_after(long step) {
    for (auto it = moments_.upper_bound(step); it != moments_.end(); it = moments_.erase(it))
        bytes_ -= it->second.bytes();
}

void KeptMoments::clear() {
    moments_.clear();
    bytes_ = 0;
    stride_ = first_stride;
}

void KeptMoments::thin() {
    stride_ *= 2;
    for (auto it = moments_.begin(); it != moments_.end();) {
        if (it->first % stride_ == 0) {
            ++it;
        } else {
            bytes_ -= it->second.bytes();
            it = moments_.erase(it);
        }
    }
}

}  // namespace whorl
