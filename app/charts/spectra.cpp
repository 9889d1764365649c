#include "app/charts/spectra.h"

#include <sys/resource.h>

#include <chrono>

namespace whorl::app {
namespace {

/// What a spectrum is made from: a copy.
struct Flow {
    int id;
    Boundary boundary;
    FaceVelocity velocity;
};

LaneSpectrum spectrum_of(const Flow& flow, Spectrum& worker) {
    worker.compute(flow.velocity, flow.boundary);
    return {
        flow.id, {worker.k().begin(), worker.k().end()}, {worker.energy().begin(), worker.energy().end()}};
}

}  // namespace

void Spectra::follow(const SessionSnapshot& session, double now) {
    if (making_.valid()) {
        if (making_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        lanes_ = making_.get();
        step_ = asked_step_;
    }
    if (session.serial == asked_ || now < since_ + period) return;
    asked_ = session.serial;
    asked_step_ = session.step;
    since_ = now;
    std::vector<Flow> flows;
    for (std::size_t k = 0; k < session.lanes.size(); ++k) {
        const Snapshot& s = session.lanes[k];
        if (s.grid().dimensions() == 2) flows.push_back({session.ids[k], s.state.boundary, s.state.velocity});
    }
    while (workers_.size() < flows.size()) workers_.push_back(std::make_unique<Spectrum>());
    making_ = std::async(std::launch::async, [this, flows = std::move(flows)] {
        constexpr int niceness = 10;
        setpriority(PRIO_PROCESS, 0, niceness);  // of this thread: it gives way to the window's
        std::vector<LaneSpectrum> made;
        for (std::size_t k = 0; k < flows.size(); ++k) made.push_back(spectrum_of(flows[k], *workers_[k]));
        return made;
    });
}

}  // namespace whorl::app
