// One row at a time, written so that compilers vectorise: no branch, no alias, sums in fixed lanes.
#include "core/pressure/poisson_rows.h"

#include "core/pressure/vector_clones.h"

namespace whorl::rows {
namespace {

inline double size(double x) {
    return x < 0 ? -x : x;
}

inline double sum_of(const double* lane) {
    return ((lane[0] + lane[1]) + (lane[2] + lane[3])) + ((lane[4] + lane[5]) + (lane[6] + lane[7]));
}

inline double largest_of(const double* lane) {
    double most = 0;
    for (int k = 0; k < lanes; ++k) most = lane[k] > most ? lane[k] : most;
    return most;
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
    double lane[lanes] = {};
    const auto value = [&](int i, double w, double e) {
        return scale * left_over<double>(d[i], b[i], south[i], w, here[i], e, north[i]);
    };
    const double first = value(0, ends.west, n > 1 ? here[1] : ends.east);
    const double last = n > 1 ? value(n - 1, here[n - 2], ends.east) : first;
    int i = 1;
    if (r) {
        for (; i + lanes < n; i += lanes) {
            for (int k = 0; k < lanes; ++k) {
                const double x = value(i + k, here[i + k - 1], here[i + k + 1]);
                r[i + k] = x;
                lane[k] = size(x) > lane[k] ? size(x) : lane[k];
            }
        }
    } else {
        for (; i + lanes < n; i += lanes) {
            for (int k = 0; k < lanes; ++k) {
                const double x = value(i + k, here[i + k - 1], here[i + k + 1]);
                lane[k] = size(x) > lane[k] ? size(x) : lane[k];
            }
        }
    }
    for (; i < n - 1; ++i) {
        const double x = value(i, here[i - 1], here[i + 1]);
        if (r) r[i] = x;
        lane[0] = size(x) > lane[0] ? size(x) : lane[0];
    }
    if (r) {
        r[0] = first;
        r[n - 1] = last;
    }
    lane[0] = size(first) > lane[0] ? size(first) : lane[0];
    lane[0] = size(last) > lane[0] ? size(last) : lane[0];
    return largest_of(lane);
}

WHORL_VECTOR_CLONES
double largest(const double* __restrict x, int n) {
    double lane[lanes] = {};
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int k = 0; k < lanes; ++k) lane[k] = size(x[i + k]) > lane[k] ? size(x[i + k]) : lane[k];
    }
    for (; i < n; ++i) lane[0] = size(x[i]) > lane[0] ? size(x[i]) : lane[0];
    return largest_of(lane);
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
void first_smoothing(const std::uint8_t* __restrict d, const double* __restrict r, float w, float* __restrict out,
                     int n) {
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
        out[i] = left_over<float>(d[i], static_cast<float>(r[i]), south[i], here[i - 1], here[i],
                           here[i + 1], north[i]);
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
    const auto value = [&](int i) {
        const double c = here[i];
        return -c * left_over<double>(d[i], 0, south[i], here[i - 1], c, here[i + 1], north[i]);
    };
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int k = 0; k < lanes; ++k) lane[k] += value(i + k);
    }
    for (int k = 0; i < n; ++i, ++k) lane[k] += value(i);
    return sum_of(lane);
}

WHORL_VECTOR_CLONES
double descend(const std::uint8_t* __restrict d, const float* __restrict south, const float* __restrict here,
               const float* __restrict north, double alpha, double gain, double* __restrict r,
               double* __restrict p, int n) {
    double lane[lanes] = {};
    const auto value = [&](int i) {
        const double c = here[i];
        const double a =
            left_over<double>(d[i], 0, south[i], here[i - 1], c, here[i + 1], north[i]);
        p[i] += gain * c;
        return r[i] += alpha * a;
    };
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        for (int k = 0; k < lanes; ++k) {
            const double x = size(value(i + k));
            lane[k] = x > lane[k] ? x : lane[k];
        }
    }
    for (; i < n; ++i) {
        const double x = size(value(i));
        lane[0] = x > lane[0] ? x : lane[0];
    }
    return largest_of(lane);
}

}  // namespace whorl::rows
