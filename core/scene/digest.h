// A number made from every bit of a state, to tell whether two runs are the same.
#pragma once

#include <cstdint>
#include <span>

#include "core/scene/state.h"

namespace whorl {

/// FNV-1a over 32-bit words of the fields, the solid cells, the step and the time.
class Digest {
  public:
    /// @param memory  a number made from what is remembered beside the state, or 0
    void add(const State& state, std::uint64_t memory);
    void add(const Field& field);
    void add(std::span<const std::uint8_t> solids);
    void add(long step, double time);
    std::uint64_t value() const { return value_; }

  private:
    void word(std::uint64_t word) {
        constexpr std::uint64_t prime = 0x100000001b3;
        value_ = (value_ ^ word) * prime;
    }
    std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace whorl
