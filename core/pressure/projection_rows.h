// The loops over one row that a projection is made of, apart from its solver.
#pragma once

#include <cstdint>

#include "core/base/real.h"

namespace whorl::rows {

/// What leaves a cell through its faces, length/time: h ∇·u.  [F 50]
inline double outflow(Real west, Real east, Real south, Real north) {
    return static_cast<double>(east) - static_cast<double>(west) + static_cast<double>(north) -
           static_cast<double>(south);
}

// `solid` is a row of the mask, non-zero in solid cells; u has one face more than the row has cells.

/// right = scale × outflow, 0 in solid cells.
/// @return the largest outflow, by size
double outflows(const std::uint8_t* solid, const Real* u, const Real* south, const Real* north, double scale,
                double* right, int n);
/// The largest outflow, by size, of a row's fluid cells.
double largest_outflow(const std::uint8_t* solid, const Real* u, const Real* south, const Real* north, int n);
/// max |q|
double largest_value(const Real* q, int n);
/// Faces between two fluid cells lose factor × (after − before); in double, for pressures differ little from
/// cell to cell.
void subtract_gradient(const std::uint8_t* solid_before, const std::uint8_t* solid_after,
                       const double* before, const double* after, double factor, Real* velocity, int n);
/// out = values
void to_field(const double* values, Real* out, int n);

}  // namespace whorl::rows
