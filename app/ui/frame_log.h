// How long the window's last frames took.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace whorl::app {

/// The last ten seconds of frames, milliseconds.
class FrameLog {
  public:
    static constexpr std::size_t kept = 600;

    /// @param interval  from the start of the last frame to the start of this one
    /// @param work      of which the window was busy
    void add(double interval, double work) {
        push(intervals_, interval);
        push(work_, work);
        ++frames_;
    }

    std::span<const float> intervals() const { return intervals_; }
    std::span<const float> work() const { return work_; }
    long frames() const { return frames_; }
    /// Number of the first frame that is kept.
    long first() const { return frames_ - static_cast<long>(intervals_.size()); }
    /// Over the last second.
    double frames_per_second() const {
        const std::size_t n = std::min<std::size_t>(intervals_.size(), 60);
        if (n == 0) return 0;
        const double ms = std::accumulate(intervals_.end() - static_cast<long>(n), intervals_.end(), 0.0);
        return ms > 0 ? 1000.0 * static_cast<double>(n) / ms : 0;
    }

  private:
    static void push(std::vector<float>& samples, double value) {
        if (samples.size() == kept) samples.erase(samples.begin());
        samples.push_back(static_cast<float>(value));
    }

    std::vector<float> intervals_, work_;
    long frames_ = 0;
};

}  // namespace whorl::app
