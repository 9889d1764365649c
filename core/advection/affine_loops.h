// Loops of the affine family: what particles carry from their departure points, and what it gives to nodes.
#pragma once

#include "core/advection/tracing_loops.h"

namespace whorl {

template <Expansion expansion, bool periodic>
struct CarryLoop {
    template <int bytes>
    static WHORL_INLINE void run(std::span<const Field* const> fields, Site site, Run nodes, const Real* dx,
                                 const Real* dy, const Carried& out) {
        using T = RealLanes<bytes>;
        const Locator<T, periodic> locator(*fields[0], site);
        const Index stride = fields[0]->stride();
        for (int k = 0; k < nodes.count; k += lane_count<T>) {
            IndexLanes<bytes> i, j;
            Point<T> at;
            locator.place(Nodes<T>(nodes.i + k, nodes.j), {load<T>(dx + k), load<T>(dy + k)}, i, j, at);
            const IndexLanes<bytes> samples = j * stride + i;
            const Carried to{out.values + k, out.stride};
            if (in_a_row(samples)) {
                take(fields, InARow<T>(samples), at, to);
            } else {
                take(fields, Apart<T>(samples), at, to);
            }
        }
    }

  private:
    template <class Samples, class T>
    static WHORL_INLINE void take(std::span<const Field* const> fields, const Samples& samples, Point<T> at,
                                  const Carried& out) {
        Real* to = out.values;
        for (const Field* field : fields) {
            const Cell<T> q(field->row(0), field->stride(), samples);
            store(q.bilinear(at.x, at.y), to);
            if constexpr (expansion != Expansion::Value) {
                store(Linear::at(q.q10 - q.q00, q.q11 - q.q01, at.y), to + out.stride);
                store(Linear::at(q.q01 - q.q00, q.q11 - q.q10, at.x), to + 2 * out.stride);
            }
            if constexpr (expansion == Expansion::CrossTerm) {
                store(q.q00 - q.q10 - q.q01 + q.q11, to + 3 * out.stride);
            }
            to += Carried::rows * out.stride;
        }
    }
};

template <Expansion expansion>
struct GatherLoop {
    template <int bytes>
    static WHORL_INLINE void run(std::span<const Share> shares, std::ptrdiff_t stride, int count,
                                 const Values& at_node, Values& sum) {
        using T = RealLanes<bytes>;
        for (int k = 0; k < count; k += lane_count<T>) {
            const T reference = load<T>(at_node + k);
            T total = load<T>(sum + k);
            for (const Share& share : shares) {
                const Real to_x = -share.particle->offset.x;  // x_i − x_s, cells
                const Real to_y = -share.particle->offset.y;
                const Real* from = share.values + k;
                T value = load<T>(from);
                if constexpr (expansion != Expansion::Value) {
                    value += load<T>(from + stride) * to_x + load<T>(from + 2 * stride) * to_y;
                }
                if constexpr (expansion == Expansion::CrossTerm) {
                    value += load<T>(from + 3 * stride) * to_x * to_y;
                }
                total += share.particle->weight * (value - reference);
            }
            store(total, sum + k);
        }
    }
};

}  // namespace whorl
