// What the last advection began with: the fields that it moved, the flow, and by what schemes.
#pragma once

#include <array>
#include <string_view>

#include "core/grid/boundary.h"
#include "core/schemes/registry.h"

namespace whorl {

/// What an advection moves.
enum class Quantity { Density, Temperature, U, V };

struct QuantityInfo {
    std::string_view key, label, symbol;
};
inline constexpr std::array<QuantityInfo, 4> quantities{{{"density", "Density", "ρ"},
                                                         {"temperature", "Temperature", "T"},
                                                         {"u", "x velocity", "u"},
                                                         {"v", "y velocity", "v"}}};
constexpr const QuantityInfo& info(Quantity quantity) {
    return quantities[static_cast<std::size_t>(quantity)];
}

/// How an advection moves its fields.
struct AdvectionSetup {
    SchemeSet velocity, scalars;
    double dt = 0;           ///< time
    std::uint64_t seed = 1;  ///< of the jittered stencil

    const SchemeSet& schemes(Quantity quantity) const {
        return quantity == Quantity::U || quantity == Quantity::V ? velocity : scalars;
    }
};

/// The last advection of a simulation, or of a copy; refers to fields that are kept there.
struct LastAdvection {
    AdvectionSetup setup;
    const Boundary* boundary = nullptr;
    const FaceVelocity* velocity = nullptr;  ///< the flow that moves everything, ghosts filled
    /// Fields as they were, ghosts filled, and as they are now: after walls, a projection that came later,
    /// and what the brush did since. By Quantity; null for what is not moved.
    std::array<const Field*, quantities.size()> before{}, now{};

    const Field* from(Quantity quantity) const { return before[static_cast<std::size_t>(quantity)]; }
    const Field* at_present(Quantity quantity) const { return now[static_cast<std::size_t>(quantity)]; }
};

}  // namespace whorl
