// Waiting for what happens in its own time.
#pragma once

#include <chrono>
#include <thread>

namespace whorl {

/// Whether something comes to be so: within a minute, which is enough for a loaded machine under a sanitizer.
template <class IsSo>
bool eventually(IsSo&& is_so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!is_so()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

/// Whether something stays so for as long as it would have taken, most likely, to change.
template <class IsSo>
bool lastingly(IsSo&& is_so) {
    for (int k = 0; k < 20; ++k) {
        if (!is_so()) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return true;
}

}  // namespace whorl
