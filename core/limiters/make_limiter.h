// The loop of a limiter, made from its formula.
#pragma once

#include <concepts>

#include "core/limiters/limiter.h"
#include "core/sampling/cell.h"

namespace whorl {

template <class Scheme>
struct LimitLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& q, const Index* at, int count, const Values& first_order,
                                 Values& value) {
        using T = RealVector<bytes>;
        const Real* origin = q.row(0);
        const Index stride = q.stride();
        for (int k = 0; k < count; k += vector_width<T>) {
            const auto cell = Cell<T>::around(origin, stride, load<IndexVector<bytes>>(at + k));
            store(Scheme::limit(load<T>(value + k), load<T>(first_order + k), cell.lowest(), cell.highest()),
                  value + k);
        }
    }
};

template <class Scheme>
LimitFn choose_limit_loop(Isa isa) {
    return PerIsa<LimitFn, LimitLoop<Scheme>>::pick(isa);
}

template <class S>
concept LimiterScheme = requires(Real q) {
    { S::limit(q, q, q, q) } -> std::same_as<Real>;
};

/// The entry of a scheme: `Scheme::info` and `traits`, and `Scheme::limit(value, first_order, low, high)`,
/// where low and high are those of the enclosing nodes; for numbers and for registers of them.
template <LimiterScheme Scheme>
constexpr Limiter make_limiter() {
    return {Scheme::info, Scheme::traits, choose_limit_loop<Scheme>};
}

}  // namespace whorl
