// Energy spectra of all lanes, worked out beside the window.
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <vector>

#include "core/measure/spectrum.h"
#include "core/session/snapshot.h"

namespace whorl::app {

/// E(k) of a lane, see whorl::Spectrum.
struct LaneSpectrum {
    int id;  ///< see Session::id
    std::vector<float> k;
    std::vector<float> energy;
};

class Spectra {
  public:
    /// Asks for the spectra of a moment, on another thread, a few times a second at most; call once a frame
    /// while they are looked at. @param now  seconds
    void follow(const SessionSnapshot& session, double now);
    /// The newest ones that are ready, and the step they are of. Lanes of one dimension have none.
    const std::vector<LaneSpectrum>& lanes() const { return lanes_; }
    long step() const { return step_; }

  private:
    static constexpr double period = 0.25;  // seconds

    std::vector<std::unique_ptr<Spectrum>> workers_;  ///< one a lane; of the thread while it works
    std::future<std::vector<LaneSpectrum>> making_;
    std::vector<LaneSpectrum> lanes_;
    long step_ = 0, asked_step_ = 0;
    std::uint64_t asked_ = ~std::uint64_t{0};  ///< serial of the moment
    double since_ = -period;
};

}  // namespace whorl::app
