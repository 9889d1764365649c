#include "app/run/history.h"

#include <algorithm>
#include <limits>

namespace whorl::app {
namespace {

constexpr std::size_t tracks = static_cast<std::size_t>(Track::Count);

/// In the order of Track.
std::array<double, tracks> values(const Measures& m) {
    return {m.time,
            m.density_percent,
            m.kinetic_energy,
            m.enstrophy,
            m.min_density,
            m.max_density,
            m.divergence_before,
            m.divergence_after,
            m.ms.forces,
            m.ms.projection,
            m.ms.advection,
            m.ms.total,
            m.errors.L1,
            m.errors.L2,
            m.errors.Linf,
            m.effective_viscosity,
            m.energy_changes.forces,
            m.energy_changes.projection,
            m.energy_changes.advection,
            m.enstrophy_changes.forces,
            m.enstrophy_changes.projection,
            m.enstrophy_changes.advection,
            m.limited.density,
            m.limited.velocity};
}

/// Keeps the samples of the steps that are multiples of `stride`.
void keep_multiples(LaneHistory& lane, long stride) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < lane.steps.size(); ++k) {
        if (static_cast<long>(lane.steps[k]) % stride != 0) continue;
        lane.steps[kept] = lane.steps[k];
        for (auto& track : lane.tracks) track[kept] = track[k];
        ++kept;
    }
    lane.steps.resize(kept);
    for (auto& track : lane.tracks) track.resize(kept);
}

}  // namespace

void History::take(std::span<const StepMeasures> measures, bool new_run) {
    if (new_run) {
        lanes_.clear();
        stride_ = 1;
        reached_ = -1;
    }
    for (const StepMeasures& row : measures) {
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

double LaneHistory::median(Track track, std::size_t count) const {
    const std::span<const float> all = of(track);
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
        lane.steps.resize(kept);
        for (auto& track : lane.tracks) track.resize(kept);
    }
    std::erase_if(lanes_, [](const auto& lane) { return lane.second.steps.empty(); });
}

void History::add(LaneHistory& lane, long step, const Measures& measures) const {
    lane.steps.push_back(static_cast<float>(step));
    const auto now = values(measures);
    for (std::size_t k = 0; k < tracks; ++k) lane.tracks[k].push_back(static_cast<float>(now[k]));
}

void History::thin() {
    stride_ *= 2;
    for (auto& [id, lane] : lanes_) keep_multiples(lane, stride_);
}

}  // namespace whorl::app
