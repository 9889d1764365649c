// Loops that follow the flow: from nodes to departure points, and from those to the cells that hold them.
#pragma once

#include "core/advection/kernels.h"
#include "core/interpolation/linear.h"
#include "core/parallel/gather.h"
#include "core/tracing/point.h"

namespace whorl {

/// Farther than any sensible trace; keeps the whole cells of a wild displacement exact in a Real.
inline constexpr Real far = 1e6F;

/// One axis of samples 0 … n − 1.
template <class T, bool periodic>
struct Axis {
    Real n, turn;

    WHORL_INLINE explicit Axis(int samples) : n(static_cast<Real>(samples)), turn(1 / n) {}

    /// The interval that holds the point `d` cells from sample `node`.
    /// Whole cells and the fraction stay apart, so that precision does not fall with the size of the grid.
    WHORL_INLINE IndexLanes<sizeof(T)> place(T node, T d, T& t) const {
        d = larger(every<T>(-far), d);  // a NaN goes here too
        d = smaller(d, every<T>(far));
        const T whole = round_down(d);
        T i = node + whole;
        t = d - whole;
        if constexpr (periodic) {
            i -= n * round_down((i + Real(0.5)) * turn);
        } else {
            const auto before = i < Real(-1);
            const auto beyond = i > n - 1;
            i = select(before, every<T>(-1), select(beyond, every<T>(n - 1), i));
            t = select(before, T{}, select(beyond, every<T>(1), t));
        }
        return to_indices(i);
    }
};

/// The four samples around a place.
template <class T>
struct Cell {
    T q00, q10, q01, q11;

    WHORL_INLINE Cell(const Reader<T>& samples, Index stride) {
        samples.pair(0, q00, q10);
        samples.pair(stride, q01, q11);
    }
    WHORL_INLINE T bilinear(T x, T y) const {
        return Linear::at(Linear::at(q00, q10, x), Linear::at(q01, q11, x), y);
    }
    WHORL_INLINE T lowest() const { return smaller(smaller(q00, q10), smaller(q01, q11)); }
    WHORL_INLINE T highest() const { return larger(larger(q00, q10), larger(q01, q11)); }
};

/// One velocity component near the nodes of a site.
template <class T, bool periodic>
struct Component {
    const Real* origin;
    Index stride;
    Axis<T, periodic> axis_x, axis_y;
    Real shift_x, shift_y;

    WHORL_INLINE Component(const Field& field, Site node)
        : origin(field.row(0)),
          stride(field.stride()),
          axis_x(field.width()),
          axis_y(field.height()),
          shift_x(static_cast<Real>(offset_x(node) - offset_x(field.site()))),
          shift_y(static_cast<Real>(offset_y(node) - offset_y(field.site()))) {}

    WHORL_INLINE T at(Point<T> node, Point<T> d) const {
        T x, y;
        const auto i = axis_x.place(node.x, d.x + shift_x, x);
        const auto j = axis_y.place(node.y, d.y + shift_y, y);
        return Cell<T>(Reader<T>(origin, j * stride + i), stride).bilinear(x, y);
    }
};

/// The velocity at points displaced from nodes, as a tracer asks for it.
template <class T, bool periodic>
struct VelocityNear {
    const Component<T, periodic>& u;
    const Component<T, periodic>& v;
    Point<T> node;

    WHORL_INLINE Point<T> operator()(Point<T> d) const { return {u.at(node, d), v.at(node, d)}; }
};

template <class Tracer, bool periodic>
struct TraceLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Flow& flow, Run nodes, Vec2 start, Real dt, Real* to_x, Real* to_y) {
        using T = RealLanes<bytes>;
        const Component<T, periodic> u(flow.velocity->u, flow.site);
        const Component<T, periodic> v(flow.velocity->v, flow.site);
        const T steps = to_values<T>(count_up<IndexLanes<bytes>>());
        const Point<T> from{every<T>(start.x), every<T>(start.y)};
        for (int k = 0; k < nodes.count; k += lane_count<T>) {
            const Point<T> node{steps + static_cast<Real>(nodes.i + k),
                                every<T>(static_cast<Real>(nodes.j))};
            const Point<T> d = Tracer::trace(VelocityNear<T, periodic>{u, v, node}, from, dt);
            store(d.x, to_x + k);
            store(d.y, to_y + k);
        }
    }
};

template <bool periodic>
struct LocateLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& field, Site site, Run nodes, const Real* dx, const Real* dy,
                                 Places& out) {
        using T = RealLanes<bytes>;
        const Axis<T, periodic> axis_x(field.width()), axis_y(field.height());
        const auto shift_x = static_cast<Real>(offset_x(site) - offset_x(field.site()));
        const auto shift_y = static_cast<Real>(offset_y(site) - offset_y(field.site()));
        const T steps = to_values<T>(count_up<IndexLanes<bytes>>());
        const Index stride = field.stride();
        for (int k = 0; k < nodes.count; k += lane_count<T>) {
            T x, y;
            const auto i =
                axis_x.place(steps + static_cast<Real>(nodes.i + k), load<T>(dx + k) + shift_x, x);
            const auto j = axis_y.place(every<T>(static_cast<Real>(nodes.j)), load<T>(dy + k) + shift_y, y);
            store(j * stride + i, out.at + k);
            store(i, out.i + k);
            store(j, out.j + k);
            store(x, out.x + k);
            store(y, out.y + k);
        }
    }
};

}  // namespace whorl
