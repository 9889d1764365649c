// Milliseconds that work takes.
#pragma once

#include <chrono>

namespace whorl {

/// Milliseconds since it was made.
class Stopwatch {
  public:
    double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds the time until the end of a scope to `ms`.
class ScopeTimer {
  public:
    explicit ScopeTimer(double& ms) : ms_(ms) {}
    ~ScopeTimer() { ms_ += watch_.ms(); }
    ScopeTimer(const ScopeTimer&) = delete;
    ScopeTimer& operator=(const ScopeTimer&) = delete;

  private:
    double& ms_;
    Stopwatch watch_;
};

}  // namespace whorl
