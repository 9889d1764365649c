// The affine semi-Lagrangian advection method and its relatives.
#pragma once

#include <algorithm>

#include "core/advection/step.h"
#include "core/schemes/scheme.h"

namespace whorl {

/// The update that the family shares: q^{n+1}(x_i) = Σ w_s (q_s + c_s · (x_i − x_s)) / Σ w_s, limited to the
/// nodes that enclose x_i^b.  [T alg 4.1, 4.1–4.3]  One trace and one sample a particle.
struct AslamUpdate {
    static constexpr bool predictor_corrector = false;
    static constexpr bool clamps_base = false;

    /// @param groups fields at the step's start, ghosts filled, and distinct ones for the result; any unit
    static void advect(const Step& step, Groups groups, std::span<Workspace>) {
        step.apply(groups, 1, [&](const Stepped& r) {
            const Group& group = groups[r.group];
            for (int f = 0; f < group.count; ++f) {
                step.kernels.limit(*group.from[f], r.at.at, r.run.count, r.first_order[f], r.q[f]);
                std::copy_n(r.q[f], r.run.count, group.to[f]->row(r.run.j) + r.run.i);
            }
        });
    }
};

/// Value and gradient of each particle.  [T 4.1–4.3]
/// About order 1 in h at fixed Δt [T table 5.2]. In 2D it is not the identity at rest: each step leaves
/// −Σ w_s c_xy s_x s_y.
struct Aslam : AslamUpdate {
    static constexpr SchemeInfo info{
        "aslam", "ASLAM", "thesis alg. 4.1, eq. 4.1–4.3",
        "Trace a stencil of particles a node; each carries its value and gradient."};
    static constexpr Expansion expansion = Expansion::Gradient;
    using Whole = Aslam;
};

/// Value alone: supersampled semi-Lagrangian.  [T 5.8]  More dissipative than semi-Lagrangian itself.
struct AslamZero : AslamUpdate {
    static constexpr SchemeInfo info{"aslam-0", "ASLAM-0", "thesis eq. 5.8",
                                     "ASLAM without the gradients: only more samples, and so more smearing."};
    static constexpr Expansion expansion = Expansion::Value;
};

/// Value, gradient and bilinear cross term c_xy (x_i − x_s)(y_i − y_s), c_xy = (q₀₀ − q₁₀ − q₀₁ + q₁₁)/h².
/// [after T sec. 6.1]  The identity at rest.
struct AslamBilinear : AslamUpdate {
    static constexpr SchemeInfo info{
        "aslam-bilinear", "ASLAM-bilinear", "after thesis sec. 6.1",
        "ASLAM with the bilinear cross term, which keeps a field at rest as it is."};
    static constexpr Expansion expansion = Expansion::CrossTerm;
    using Whole = AslamBilinear;
};

/// ASLAM as a base step that keeps its clamp: the thesis' MC-ASLAM-CLAMPED.  [T sec. 5.5]
struct AslamClamped : Aslam {
    static constexpr SchemeInfo info{"aslam-clamped", "ASLAM, clamped", "thesis sec. 5.5",
                                     "ASLAM with its clamp kept inside the predictor and the corrector."};
    static constexpr bool clamps_base = true;
};

}  // namespace whorl
