// From points near nodes to the intervals of samples that hold them.
#pragma once

#include <type_traits>

#include "core/grid/sides.h"
#include "core/sampling/node_span.h"

namespace whorl {

/// Farther than any sensible trace; keeps the whole cells of a wild displacement exact in a Real.
inline constexpr Real far = 1e6F;

/// One axis of samples 0 … n − 1.
template <class T, bool wraps>
struct Axis {
    Real n, turn;

    WHORL_INLINE explicit Axis(int samples) : n(static_cast<Real>(samples)), turn(1 / n) {}

    /// The interval that holds the point `d` cells from sample `node`.
    /// Whole cells and the fraction stay apart, so that precision does not fall with the size of the grid.
    WHORL_INLINE IndexVector<sizeof(T)> place(T node, T d, T& t) const {
        if constexpr (wraps) {
            d = smaller(larger(broadcast<T>(-far), d), broadcast<T>(far));  // a NaN goes to −far
            const T whole = round_down(d);
            const T i = node + whole;
            t = d - whole;
            return to_indices(i - n * round_down((i + Real(0.5)) * turn));
        } else {
            // From one sample before the first to one after the last, where ghost values still are.
            const T end = n - node;
            d = smaller(larger(Real(-1) - node, d), end);
            const T whole = smaller(end - 1, round_down(d));
            t = d - whole;
            return to_indices(node + whole);
        }
    }
    /// Whether samples i … i + count − 1 begin intervals that need no care.
    WHORL_INLINE bool contains(int i, int count) const {
        return i >= (wraps ? 0 : -1) && static_cast<Real>(i + count) <= n;
    }
};

/// Turns a run-time choice into a template argument.
template <class F>
auto with_bool(bool value, F&& f) {
    return value ? f(std::true_type{}) : f(std::false_type{});
}
/// The same for the axes that wrap.
template <class F>
auto with_wraps(Wraps wraps, F&& f) {
    return with_bool(wraps.x,
                     [&]<class X>(X x) { return with_bool(wraps.y, [&]<class Y>(Y y) { return f(x, y); }); });
}

/// A vector of neighbouring nodes of one row.
template <class T>
struct Nodes {
    int i, j;
    T x, y;

    WHORL_INLINE Nodes(int first, int row)
        : i(first),
          j(row),
          x(to_values<T>(count_up<IndexVector<sizeof(T)>>()) + static_cast<Real>(first)),
          y(broadcast<T>(static_cast<Real>(row))) {}
};

}  // namespace whorl
