#include "app/run/history.h"

#include <algorithm>
#include <limits>

namespace whorl::app {
namespace {

/// Calls `act` for the steps, the times and every curve of a lane.
template <class Act>
void for_samples(LaneHistory& lane, Act&& act) {
    act(lane.steps);
    act(lane.times);
    for (std::vector<float>& curve : lane.curves) act(curve);
}

/// Keeps the samples of the steps that are multiples of `stride`.
void keep_multiples(LaneHistory& lane, long stride) {
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < lane.steps.size(); ++k) {
        if (static_cast<long>(lane.steps[k]) % stride == 0) kept.push_back(k);
    }
    for_samples(lane, [&](std::vector<float>& samples) {
        for (std::size_t k = 0; k < kept.size(); ++k) samples[k] = samples[kept[k]];
        samples.resize(kept.size());
    });
}

}  // namespace

void History::take(std::span<const StepMeasures> rows, bool new_run) {
    if (new_run) {
        lanes_.clear();
        stride_ = 1;
        reached_ = -1;
    }
    for (const StepMeasures& row : rows) {
        if (row.step <= reached_) truncate(row.step);
        reached_ = row.step;
        for (std::size_t k = 0; k < row.ids.size(); ++k) {
            LaneHistory& lane = lanes_[row.ids[k]];
            lane.last = row.lanes[k];
            if (lane.steps.size() == capacity) thin();
            if (row.step % stride_ == 0) add(lane, row.step, row.lanes[k]);
        }
    }
}

std::span<const float> LaneHistory::of(const Measure& measure) const {
    const std::size_t place = measures().index(measure);
    return place < curves.size() ? std::span<const float>(curves[place]) : std::span<const float>();
}

double LaneHistory::median(const Measure& measure, std::size_t count) const {
    const std::span<const float> all = of(measure);
    const std::span<const float> tail = all.last(std::min(count, all.size()));
    std::vector<float> values(tail.begin(), tail.end());
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return static_cast<double>(*middle);
}

const LaneHistory& History::lane(int id) const {
    static const LaneHistory none{};
    const auto found = lanes_.find(id);
    return found == lanes_.end() ? none : found->second;
}

void History::truncate(long step) {
    for (auto& [id, lane] : lanes_) {
        const auto from = std::lower_bound(lane.steps.begin(), lane.steps.end(), static_cast<float>(step));
        const auto kept = static_cast<std::size_t>(from - lane.steps.begin());
        for_samples(lane, [&](std::vector<float>& samples) { samples.resize(kept); });
    }
    std::erase_if(lanes_, [](const auto& lane) { return lane.second.steps.empty(); });
}

void History::add(LaneHistory& lane, long step, const Measures& measured) const {
    const auto all = measures().all();
    lane.curves.resize(all.size());
    lane.steps.push_back(static_cast<float>(step));
    lane.times.push_back(static_cast<float>(measured.time));
    for (std::size_t k = 0; k < all.size(); ++k)
        lane.curves[k].push_back(static_cast<float>(all[k]->of(measured)));
}

void History::thin() {
    stride_ *= 2;
    for (auto& [id, lane] : lanes_) keep_multiples(lane, stride_);
}

}  // namespace whorl::app
