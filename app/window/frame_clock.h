// Sixty frames a second, whatever the swap interval does.
#pragma once

#include <chrono>
#include <thread>

namespace whorl::app {

class FrameClock {
  public:
    using Clock = std::chrono::steady_clock;

    FrameClock() : origin_(Clock::now()), due_(origin_), start_(origin_), end_of_work_(origin_) {}

    /// Sleeps until the next frame is due. A frame that was a little late is made up for by the next ones;
    /// more than a frame is not.
    void wait() {
        end_of_work_ = Clock::now();
        due_ += period;
        const Clock::time_point now = Clock::now();
        if (due_ > now) {
            std::this_thread::sleep_until(due_);
        } else if (now - due_ > period) {
            due_ = now;
        }
        const Clock::time_point start = Clock::now();
        interval_ = start - start_;
        work_ = end_of_work_ - start_;
        start_ = start;
    }

    /// Seconds since the clock was made, at the frame's start.
    double time() const { return seconds(start_ - origin_); }
    /// From the last frame's start to this one's, milliseconds, and how long of it was spent working.
    double interval_ms() const { return 1e3 * seconds(interval_); }
    double work_ms() const { return 1e3 * seconds(work_); }

  private:
    static constexpr std::chrono::nanoseconds period{16'666'667};

    static double seconds(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

    Clock::time_point origin_, due_, start_, end_of_work_;
    Clock::duration interval_{}, work_{};
};

}  // namespace whorl::app
