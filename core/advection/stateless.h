// Transport without memory: a function of the old fields alone.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/advection/lattice.h"
#include "core/advection/step.h"
#include "core/advection/transport.h"
#include "core/stencils/stencil.h"

namespace whorl {

/// One step of some fields, at most one group a site.
/// @param groups fields at the step's start, ghosts filled, and distinct ones for the result; any unit
/// @param work   a workspace a group, kept from step to step
using AdvectFn = void (*)(const Step& step, Groups groups, std::span<Workspace> work);

class Stateless final : public Transport {
  public:
    explicit Stateless(AdvectFn function) : advect_(function) {}

    bool prepare(const TransportSetup& setup) override;
    void advect(std::span<const AdvectedField> fields, const AdvectionStep& step) override;
    const Workspace* workspace() const override { return work_.data(); }

  private:
    AdvectFn advect_;
    TransportSetup setup_;
    std::optional<Stencil> stencil_;
    std::optional<Lattice> lattice_;
    std::vector<LatticeTile> tiles_;  ///< one a thread
    std::array<Workspace, max_groups> work_;
};

/// For an advector's `make`.
template <AdvectFn function>
std::unique_ptr<Transport> stateless() {
    return std::make_unique<Stateless>(function);
}

}  // namespace whorl
