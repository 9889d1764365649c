#include "app/panels/history.h"

#include <algorithm>

namespace whorl::app {
namespace {

constexpr std::size_t tracks = static_cast<std::size_t>(Track::Count);

/// In the order of Track.
std::array<double, tracks> values(const Measures& m) {
    return {m.density_percent,  m.kinetic_energy, m.enstrophy,     m.divergence_before,
            m.divergence_after, m.ms.forces,      m.ms.projection, m.ms.advection,
            m.ms.total,         m.errors.L1,      m.errors.L2,     m.errors.Linf};
}

void keep_even(std::vector<float>& samples) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < samples.size(); k += 2) samples[kept++] = samples[k];
    samples.resize(kept);
}

}  // namespace

History::History() {
    steps_.reserve(capacity);
    for (auto& track : tracks_) track.reserve(capacity);
}

void History::take(std::span<const StepMeasures> measures, int lane, bool new_run) {
    if (new_run) {
        steps_.clear();
        for (auto& track : tracks_) track.clear();
        stride_ = 1;
    }
    for (const StepMeasures& row : measures) {
        const auto found = std::find(row.ids.begin(), row.ids.end(), lane);
        if (found != row.ids.end()) add(row.lanes[static_cast<std::size_t>(found - row.ids.begin())]);
    }
}

void History::add(const Measures& m) {
    last_ = m;
    if (m.step % stride_ != 0) return;
    if (steps_.size() == capacity) {
        thin();
        if (m.step % stride_ != 0) return;
    }
    steps_.push_back(static_cast<float>(m.step));
    const auto now = values(m);
    for (std::size_t k = 0; k < tracks; ++k) tracks_[k].push_back(static_cast<float>(now[k]));
}

void History::thin() {
    keep_even(steps_);
    for (auto& track : tracks_) keep_even(track);
    stride_ *= 2;
}

}  // namespace whorl::app
