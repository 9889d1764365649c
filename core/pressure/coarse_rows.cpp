#include "core/pressure/coarse_rows.h"

#include "core/pressure/vector_clones.h"

namespace whorl::rows {
namespace {

inline float left_over(float b, float kw, float ke, float ks, float kn, float s, float w, float c, float e,
                       float n) {
    return b - ((kw * (c - w) + ke * (c - e)) + (ks * (c - s) + kn * (c - n)));
}

}  // namespace

WHORL_VECTOR_CLONES
void first_smoothing(const CoarseRow& row, const float* __restrict b, float w, float* __restrict out, int n) {
    const float* __restrict inverse = row.inverse;
    for (int i = 0; i < n; ++i) out[i] = w * b[i] * inverse[i];
}

WHORL_VECTOR_CLONES
void smoothing(const CoarseRow& row, const float* __restrict b, const float* __restrict south,
               const float* __restrict here, const float* __restrict north, float w, float* __restrict out,
               int n) {
    const float* __restrict kx = row.across;
    const float* __restrict ks = row.south;
    const float* __restrict kn = row.north;
    const float* __restrict inverse = row.inverse;
    for (int i = 0; i < n; ++i) {
        out[i] = here[i] + w * inverse[i] *
                               left_over(b[i], kx[i], kx[i + 1], ks[i], kn[i], south[i], here[i - 1], here[i],
                                         here[i + 1], north[i]);
    }
}

WHORL_VECTOR_CLONES
void smoothed_residual(const CoarseRow& row, const float* __restrict b, const float* __restrict south,
                       const float* __restrict here, const float* __restrict north, float* __restrict out,
                       int n) {
    const float* __restrict kx = row.across;
    const float* __restrict ks = row.south;
    const float* __restrict kn = row.north;
    for (int i = 0; i < n; ++i) {
        out[i] = left_over(b[i], kx[i], kx[i + 1], ks[i], kn[i], south[i], here[i - 1], here[i], here[i + 1],
                           north[i]);
    }
}

WHORL_VECTOR_CLONES
void gather(const CornerWeights& lean, const float* __restrict below, const float* __restrict low,
            const float* __restrict high, const float* __restrict above, float* __restrict out, int n) {
    const float* __restrict lx = lean.across;
    const float* __restrict ls = lean.south;
    const float* __restrict ln = lean.north;
    for (int i = 0; i < n; ++i) {
        const int k = 2 * i;
        const float before = low[k - 1] + high[k - 1];
        const float left = low[k] + high[k];
        const float right = low[k + 1] + high[k + 1];
        const float after = low[k + 2] + high[k + 2];
        const float across = lx[i] * (before - left) + lx[i + 1] * (after - right);
        const float down = ls[i] * ((below[k] + below[k + 1]) - (low[k] + low[k + 1]));
        const float up = ln[i] * ((above[k] + above[k + 1]) - (high[k] + high[k + 1]));
        out[i] = (left + right) + (across + (down + up));
    }
}

WHORL_VECTOR_CLONES
void carry(const float* __restrict across, const float* __restrict towards, const float* __restrict parents,
           const float* __restrict beside, const float* __restrict z, float* __restrict out, int n) {
    for (int i = 0; i < n; ++i) {
        const float c = parents[i];
        const float middle = c + towards[i] * (beside[i] - c);
        out[2 * i] = z[2 * i] + (middle + across[i] * (parents[i - 1] - c));
        out[2 * i + 1] = z[2 * i + 1] + (middle + across[i + 1] * (parents[i + 1] - c));
    }
}

}  // namespace whorl::rows
