// The loops over one row of cells that the finest grid's solvers are made of.
#pragma once

#include <cstdint>

namespace whorl::rows {

/// Lanes of a sum over a row: cell i adds to lane i mod 8, and lanes are added pairwise, on any machine.
constexpr int lanes = 8;

// In all of these `d` are the open faces of a row's cells (Poisson::degrees); `south`, `here`, `north` are
// rows of values, 0 in solid cells. Float rows have a value before their first and after their last sample:
// the wrapped one in a periodic domain, else 0.

/// Values beside a row without such a border: those next to its ends, or 0.
struct Ends {
    double west = 0;
    double east = 0;
};

/// r = scale (b − A p); r may be null.
/// @return max |r|
double residual(const std::uint8_t* d, const double* b, const double* south, const double* here,
                const double* north, Ends ends, double scale, double* r, int n);
/// max |x|
double largest(const double* x, int n);
/// Σ x y
double dot(const double* x, const float* y, int n);

/// One step of weighted Jacobi from z = 0: out = w r / d, 0 where d is 0.
void first_smoothing(const std::uint8_t* d, const double* r, float w, float* out, int n);
/// One step of weighted Jacobi: out = z + w (r − A z) / d, 0 where d is 0.
void smoothing(const std::uint8_t* d, const double* r, const float* south, const float* here,
               const float* north, float w, float* out, int n);
/// out = r − A z, 0 where d is 0.
void smoothed_residual(const std::uint8_t* d, const double* r, const float* south, const float* here,
                       const float* north, float* out, int n);
/// x = 0 where d is 0.
void mask(const std::uint8_t* d, float* x, int n);

/// out = z + beta s
void combine(const float* z, float beta, const float* s, float* out, int n);
/// Σ s (A s)
double energy(const std::uint8_t* d, const float* south, const float* here, const float* north, int n);
/// r −= alpha A s, p += gain s
/// @return max |r|
double descend(const std::uint8_t* d, const float* south, const float* here, const float* north, double alpha,
               double gain, double* r, double* p, int n);

}  // namespace whorl::rows
