#include "core/pressure/projection_rows.h"

#include <cmath>

#include "core/pressure/vector_clones.h"

namespace whorl::rows {
namespace {

/// Maxima that a row is spread over, so that compilers vectorise.
constexpr int block = 64;

inline double largest_of(const double* most) {
    double all = 0;
    for (int k = 0; k < block; ++k) all = most[k] > all ? most[k] : all;
    return all;
}

}  // namespace

WHORL_VECTOR_CLONES
double outflows(const std::uint8_t* __restrict solid, const Real* __restrict u, const Real* __restrict south,
                const Real* __restrict north, double scale, double* __restrict right, int n) {
    double most[block] = {};
    for (int start = 0; start < n; start += block) {
        const int m = n - start < block ? n - start : block;
        for (int k = 0; k < m; ++k) {
            const int i = start + k;
            const double all = outflow(u[i], u[i + 1], south[i], north[i]);
            const double out = solid[i] ? 0 : all;
            right[i] = scale * out;
            most[k] = std::fabs(out) > most[k] ? std::fabs(out) : most[k];
        }
    }
    return largest_of(most);
}

WHORL_VECTOR_CLONES
double largest_outflow(const std::uint8_t* __restrict solid, const Real* __restrict u,
                       const Real* __restrict south, const Real* __restrict north, int n) {
    double most[block] = {};
    for (int start = 0; start < n; start += block) {
        const int m = n - start < block ? n - start : block;
        for (int k = 0; k < m; ++k) {
            const int i = start + k;
            const double all = outflow(u[i], u[i + 1], south[i], north[i]);
            const double out = solid[i] ? 0 : all;
            most[k] = std::fabs(out) > most[k] ? std::fabs(out) : most[k];
        }
    }
    return largest_of(most);
}

WHORL_VECTOR_CLONES
double largest_value(const Real* __restrict q, int n) {
    double most[block] = {};
    for (int start = 0; start < n; start += block) {
        const int m = n - start < block ? n - start : block;
        for (int k = 0; k < m; ++k) {
            const double x = std::fabs(static_cast<double>(q[start + k]));
            most[k] = x > most[k] ? x : most[k];
        }
    }
    return largest_of(most);
}

WHORL_VECTOR_CLONES
void subtract_gradient(const std::uint8_t* __restrict solid_before,
                       const std::uint8_t* __restrict solid_after, const double* __restrict before,
                       const double* __restrict after, double factor, Real* __restrict velocity, int n) {
    for (int i = 0; i < n; ++i) {
        const double slope = factor * (after[i] - before[i]);
        const double change = (solid_before[i] | solid_after[i]) ? 0 : slope;
        velocity[i] = static_cast<Real>(static_cast<double>(velocity[i]) - change);
    }
}

WHORL_VECTOR_CLONES
void to_field(const double* __restrict values, Real* __restrict out, int n) {
    for (int i = 0; i < n; ++i) out[i] = static_cast<Real>(values[i]);
}

}  // namespace whorl::rows
