// An interpolation at a place, written out.
#pragma once

#include <string_view>

#include "core/inspect/explanation.h"

namespace whorl {

/// A place in a field.
struct PointInCell {
    int i, j;   ///< of the sample below and to the left of it
    Real x, y;  ///< from there, 0 to 1
};

/// "ρ(3, 7)", by the node that a periodic border repeats.
std::string node_name(std::string_view symbol, const Field& q, const Boundary& boundary, int i, int j);

/// How a field's value at a place comes from its nodes, before any clamp: as a weighted sum [T 3.6–3.7] where
/// the scheme is one, and by the cubics along both axes [T 3.12] where it has slopes.
/// @param symbol of the field
/// @param value  as the solver has it
/// @param nodes  gets what the scheme reads
Sum interpolation_sum(const Field& q, std::string_view symbol, const Boundary& boundary,
                      const SchemeSet& schemes, const PointInCell& at, Real value,
                      std::vector<KernelNode>& nodes);

}  // namespace whorl
