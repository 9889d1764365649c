// Loops of the affine family: sampling at the departure points of particles, and adding it up at nodes.
#pragma once

#include "core/advection/kernels.h"
#include "core/sampling/cell.h"
#include "core/sampling/locate_loop.h"

namespace whorl {

template <Expansion expansion, bool wraps_x, bool wraps_y>
struct SampleParticlesLoop {
    template <int bytes>
    static WHORL_INLINE void run(std::span<const Field* const> fields, Site site, NodeSpan nodes,
                                 const Real* dx, const Real* dy, const ParticleSamples& out) {
        using T = RealVector<bytes>;
        const Locator<T, wraps_x, wraps_y> locator(*fields[0], site);
        const Index stride = fields[0]->stride();
        for (int k = 0; k < nodes.count; k += vector_width<T>) {
            IndexVector<bytes> i, j;
            Point<T> at;
            locator.place(Nodes<T>(nodes.i + k, nodes.j), {load<T>(dx + k), load<T>(dy + k)}, i, j, at);
            const IndexVector<bytes> samples = j * stride + i;
            const ParticleSamples to{out.values + k, out.stride};
            if (is_contiguous(samples)) {
                sample(fields, Contiguous<T>(samples), at, to);
            } else {
                sample(fields, Gathered<T>(samples), at, to);
            }
        }
    }

  private:
    template <class Samples, class T>
    static WHORL_INLINE void sample(std::span<const Field* const> fields, const Samples& samples, Point<T> at,
                                    const ParticleSamples& out) {
        Real* to = out.values;
        for (const Field* field : fields) {
            const Cell<T> q(field->row(0), field->stride(), samples);
            store(q.bilinear(at.x, at.y), to);
            if constexpr (expansion != Expansion::Value) {
                store(lerp(q.q10 - q.q00, q.q11 - q.q01, at.y), to + out.stride);
                store(lerp(q.q01 - q.q00, q.q11 - q.q10, at.x), to + 2 * out.stride);
            }
            if constexpr (expansion == Expansion::CrossTerm) {
                store(q.q00 - q.q10 - q.q01 + q.q11, to + 3 * out.stride);
            }
            to += ParticleSamples::rows * out.stride;
        }
    }
};

template <Expansion expansion>
struct AddContributionsLoop {
    template <int bytes>
    static WHORL_INLINE void run(std::span<const Contribution> contributions, std::ptrdiff_t stride,
                                 int count, const Values& at_node, Values& sum) {
        using T = RealVector<bytes>;
        for (int k = 0; k < count; k += vector_width<T>) {
            const T reference = load<T>(at_node + k);
            T total = load<T>(sum + k);
            for (const Contribution& one : contributions) {
                const Real to_x = -one.particle->offset.x;  // x_i − x_s, cells
                const Real to_y = -one.particle->offset.y;
                const Real* from = one.values + k;
                T value = load<T>(from);
                if constexpr (expansion != Expansion::Value) {
                    value += load<T>(from + stride) * to_x + load<T>(from + 2 * stride) * to_y;
                }
                if constexpr (expansion == Expansion::CrossTerm) {
                    value += load<T>(from + 3 * stride) * to_x * to_y;
                }
                total += one.particle->weight * (value - reference);
            }
            store(total, sum + k);
        }
    }
};

}  // namespace whorl
