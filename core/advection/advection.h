// Advecting fields with the flow: the one way in for every scheme.
#pragma once

#include "core/advection/step.h"
#include "core/advection/transport.h"

namespace whorl {

/// Advects fields by one set of schemes; keeps its transport from step to step.
class Advection {
  public:
    void set(const TransportSetup& setup);
    const SchemeSet& schemes() const { return setup_.schemes; }

    /// One step.
    /// @param fields   any number at any sites: at the step's start, ghosts filled, and distinct ones for the
    ///                 result, whose ghosts are filled too; any unit
    void advect(std::span<const AdvectedField> fields, const AdvectionStep& step);
    void advect(const Field& from, Field& to, const AdvectionStep& step) {
        const AdvectedField field{&from, &to};
        advect({&field, 1}, step);
    }

    /// What the last advect of one field left of a predictor-corrector's way: its forward and its corrected
    /// field; null for other schemes.
    const Workspace* workspace() const { return transport_->workspace(); }

  private:
    TransportSetup setup_;
    std::unique_ptr<Transport> transport_;
};

}  // namespace whorl
