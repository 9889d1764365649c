// Whether a run that was brought back has become what it was.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/session/snapshot.h"

namespace whorl::app {

class ReplayCheck {
  public:
    /// A recording was loaded. @param run  the number that its snapshots will have
    void expect(const Recording& recording, std::string name, int run) {
        expected_.reset();
        if (recording.digest != 0) expected_ = {recording.digest, recording.step, std::move(name), run, {}};
    }

    /// @param loaded  what was loaded last
    /// @return once, when the recorded step is reached: whether the bits are the recorded ones
    std::optional<bool> follow(const SessionSnapshot& session, const std::string& loaded) {
        if (!expected_ || session.run < expected_->run) return {};
        if (!expected_->taken) expected_->taken = session.taken;
        // Someone else's run, or a person has acted in it.
        if (session.run > expected_->run || loaded != expected_->name || session.taken != *expected_->taken) {
            expected_.reset();
            return {};
        }
        if (session.step != expected_->step) return {};
        const bool same = session.digest() == expected_->digest;
        expected_.reset();
        return same;
    }

  private:
    struct Expected {
        std::uint64_t digest;
        long step;
        std::string name;
        int run;
        std::optional<std::uint64_t> taken;  ///< commands at its start
    };
    std::optional<Expected> expected_;
};

}  // namespace whorl::app
