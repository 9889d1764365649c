// Loops of the affine family: what particles carry from their departure points, and what it gives to nodes.
#pragma once

#include "core/advection/tracing_loops.h"

namespace whorl {

template <Expansion expansion>
struct CarryLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& field, const Places& at, int count, const Carried& out) {
        using T = RealLanes<bytes>;
        const Real* origin = field.row(0);
        const Index stride = field.stride();
        for (int k = 0; k < count; k += lane_count<T>) {
            const Cell<T> q(Reader<T>(origin, load<IndexLanes<bytes>>(at.at + k)), stride);
            const T x = load<T>(at.x + k), y = load<T>(at.y + k);
            Real* to = out.values + k;
            store(q.bilinear(x, y), to);
            if constexpr (expansion != Expansion::Value) {
                store(Linear::at(q.q10 - q.q00, q.q11 - q.q01, y), to + out.stride);
                store(Linear::at(q.q01 - q.q00, q.q11 - q.q10, x), to + 2 * out.stride);
            }
            if constexpr (expansion == Expansion::CrossTerm) {
                store(q.q00 - q.q10 - q.q01 + q.q11, to + 3 * out.stride);
            }
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
                const Real to_x = -share.particle.offset.x;  // x_i − x_s, cells
                const Real to_y = -share.particle.offset.y;
                const Real* from = share.values + k;
                T value = load<T>(from);
                if constexpr (expansion != Expansion::Value) {
                    value += load<T>(from + stride) * to_x + load<T>(from + 2 * stride) * to_y;
                }
                if constexpr (expansion == Expansion::CrossTerm) {
                    value += load<T>(from + 3 * stride) * to_x * to_y;
                }
                total += share.particle.weight * (value - reference);
            }
            store(total, sum + k);
        }
    }
};

}  // namespace whorl
