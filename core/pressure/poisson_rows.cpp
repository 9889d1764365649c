// One row at a time, written so that compilers vectorise: no branch, no alias, sums in fixed lanes.
#include "core/pressure/poisson_rows.h"

#include <cmath>

#include "core/pressure/vector_clones.h"

namespace whorl::rows {
namespace {

inline double sum_of(const double* lane) {
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

/// Cells at a time: values go through a short array, and then into lanes, each a loop that vectorises.
constexpr int block = 64;

inline void add_in_lanes(const double* __restrict values, int n, double* __restrict lane) {
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int k = 0; k < lanes; ++k) lane[k] += values[i + k];
    }
    for (int k = 0; i < n; ++i, ++k) lane[k] += values[i];
}

/// Raises each of `block` maxima to its value's size.
inline void raise(const double* __restrict values, int n, double* __restrict most) {
    for (int i = 0; i < n; ++i) {
        const double x = std::fabs(values[i]);
        most[i] = x > most[i] ? x : most[i];
    }
}

inline double largest_of(const double* most) {
    double all = 0;
    for (int k = 0; k < block; ++k) all = most[k] > all ? most[k] : all;
    return all;
}

/// r − A z of one cell, 0 where it has no open face.
template <class T>
inline T left_over(T d, T r, T south, T west, T here, T east, T north) {
    return d > 0 ? r - (d * here - ((west + east) + (south + north))) : 0;
}

inline float inverse(float d) {
    return 1 / (d > 0 ? d : 1);
}

}  // namespace

WHORL_VECTOR_CLONES
double residual(const std::uint8_t* __restrict d, const double* __restrict b, const double* __restrict south,
                const double* __restrict here, const double* __restrict north, Ends ends, double scale,
                double* __restrict r, int n) {
    double most[block] = {};
    double values[block];
    for (int start = 0; start < n; start += block) {
        const int end = start + block < n ? start + block : n;
        const int first = start > 0 ? start : 1;
        const int last = end < n ? end : n - 1;
        for (int i = first; i < last; ++i)
            values[i - start] =
                scale * left_over<double>(d[i], b[i], south[i], here[i - 1], here[i], here[i + 1], north[i]);
        if (start == 0)
            values[0] = scale * left_over<double>(d[0], b[0], south[0], ends.west, here[0],
                                                  n > 1 ? here[1] : ends.east, north[0]);
        if (end == n && n > 1)
            values[n - 1 - start] = scale * left_over<double>(d[n - 1], b[n - 1], south[n - 1], here[n - 2],
                                                              here[n - 1], ends.east, north[n - 1]);
        if (r) {
            for (int i = start; i < end; ++i) r[i] = values[i - start];
        }
        raise(values, end - start, most);
    }
    return largest_of(most);
}

WHORL_VECTOR_CLONES
double largest(const double* __restrict x, int n) {
    double most[block] = {};
    for (int start = 0; start < n; start += block)
        raise(x + start, n - start < block ? n - start : block, most);
    return largest_of(most);
}

WHORL_VECTOR_CLONES
double dot(const double* __restrict x, const float* __restrict y, int n) {
    double lane[lanes] = {};
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int k = 0; k < lanes; ++k) lane[k] += x[i + k] * static_cast<double>(y[i + k]);
    }
    for (int k = 0; i < n; ++i, ++k) lane[k] += x[i] * static_cast<double>(y[i]);
    return sum_of(lane);
}

WHORL_VECTOR_CLONES
void first_smoothing(const std::uint8_t* __restrict d, const double* __restrict r, float w,
                     float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) {
        const float faces = d[i];
        const float x = w * static_cast<float>(r[i]) * inverse(faces);
        out[i] = faces > 0 ? x : 0;
    }
}

WHORL_VECTOR_CLONES
void smoothing(const std::uint8_t* __restrict d, const double* __restrict r, const float* __restrict south,
               const float* __restrict here, const float* __restrict north, float w, float* __restrict out,
               int n) {
    for (int i = 0; i < n; ++i) {
        const float faces = d[i];
        const float left = left_over<float>(faces, static_cast<float>(r[i]), south[i], here[i - 1], here[i],
                                            here[i + 1], north[i]);
        out[i] = here[i] + w * left * inverse(faces);
    }
}

WHORL_VECTOR_CLONES
void smoothed_residual(const std::uint8_t* __restrict d, const double* __restrict r,
                       const float* __restrict south, const float* __restrict here,
                       const float* __restrict north, float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) {
        out[i] = left_over<float>(d[i], static_cast<float>(r[i]), south[i], here[i - 1], here[i], here[i + 1],
                                  north[i]);
    }
}

WHORL_VECTOR_CLONES
void mask(const std::uint8_t* __restrict d, float* __restrict x, int n) {
    for (int i = 0; i < n; ++i) x[i] = d[i] > 0 ? x[i] : 0;
}

WHORL_VECTOR_CLONES
void combine(const float* __restrict z, float beta, const float* __restrict s, float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) out[i] = z[i] + beta * s[i];
}

WHORL_VECTOR_CLONES
double energy(const std::uint8_t* __restrict d, const float* __restrict south, const float* __restrict here,
              const float* __restrict north, int n) {
    double lane[lanes] = {};
    double values[block];
    for (int start = 0; start < n; start += block) {
        const int end = start + block < n ? start + block : n;
        for (int i = start; i < end; ++i) {
            const double c = here[i];
            values[i - start] =
                -c * left_over<double>(d[i], 0, south[i], here[i - 1], c, here[i + 1], north[i]);
        }
        add_in_lanes(values, end - start, lane);
    }
    return sum_of(lane);
}

WHORL_VECTOR_CLONES
double descend(const std::uint8_t* __restrict d, const float* __restrict south, const float* __restrict here,
               const float* __restrict north, double alpha, double gain, double* __restrict r,
               double* __restrict p, int n) {
    double most[block] = {};
    double values[block];
    for (int start = 0; start < n; start += block) {
        const int end = start + block < n ? start + block : n;
        for (int i = start; i < end; ++i) {
            const double c = here[i];
            values[i - start] =
                r[i] + alpha * left_over<double>(d[i], 0, south[i], here[i - 1], c, here[i + 1], north[i]);
        }
        for (int i = start; i < end; ++i) {
            p[i] += gain * static_cast<double>(here[i]);
            r[i] = values[i - start];
        }
        raise(values, end - start, most);
    }
    return largest_of(most);
}

}  // namespace whorl::rows
