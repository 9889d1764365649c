// Advecting fields with the flow: the one way in for every scheme.
#pragma once

#include <vector>

#include "core/advection/step.h"
#include "core/advection/transport.h"

namespace whorl {

/// What a transport with memory kept; nothing for others, nor where it is to be seeded.
struct TransportMemory {
    std::size_t fields = 0;  ///< that it was seeded with
    std::vector<std::byte> bytes;

    bool operator==(const TransportMemory&) const = default;
};

/// Advects fields by one set of schemes; keeps its transport from step to step.
class Advection {
  public:
    /// Another advector drops the memory of the last one.
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

    /// Brush, emitters or walls changed the fields in these cells.
    void edited(const CellRange& cells);
    /// The memory is of no use any more: the next step seeds it.
    void forget() { seeded_ = 0; }
    TransportMemory memory() const;
    /// @pre the setup is the one of then
    void restore(const TransportMemory& memory);
    /// Made from every bit of the memory; 0 where there is none.
    std::uint64_t memory_digest() const;

  private:
    TransportSetup setup_;
    std::unique_ptr<Transport> transport_;
    std::size_t seeded_ = 0;  ///< with how many fields a memory has been seeded; 0: not
};

}  // namespace whorl
