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
        if constexpr (periodic) {
            d = smaller(larger(every<T>(-far), d), every<T>(far));  // a NaN goes to −far
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
        return i >= (periodic ? 0 : -1) && static_cast<Real>(i + count) <= n;
    }
};

/// The four samples around places.
template <class T>
struct Cell {
    T q00, q10, q01, q11;

    template <class Samples>
    WHORL_INLINE Cell(const Real* origin, Index stride, const Samples& at) {
        at.pair(origin, q00, q10);
        at.pair(origin + stride, q01, q11);
    }
    static WHORL_INLINE Cell around(const Real* origin, Index stride, IndexLanes<sizeof(T)> at) {
        return in_a_row(at) ? Cell(origin, stride, InARow<T>(at)) : Cell(origin, stride, Apart<T>(at));
    }
    /// Of places in a row, the first of them at `from`.
    WHORL_INLINE Cell(const Real* from, Index stride)
        : q00(load<T>(from)),
          q10(load<T>(from + 1)),
          q01(load<T>(from + stride)),
          q11(load<T>(from + stride + 1)) {}

    /// One axis first, then the other.
    template <class Interpolation, bool x_first>
    WHORL_INLINE T at(T x, T y) const {
        if constexpr (x_first) {
            return Interpolation::at(Interpolation::at(q00, q10, x), Interpolation::at(q01, q11, x), y);
        } else {
            return Interpolation::at(Interpolation::at(q00, q01, y), Interpolation::at(q10, q11, y), x);
        }
    }
    WHORL_INLINE T bilinear(T x, T y) const { return at<Linear, true>(x, y); }
    WHORL_INLINE T lowest() const { return smaller(smaller(q00, q10), smaller(q01, q11)); }
    WHORL_INLINE T highest() const { return larger(larger(q00, q10), larger(q01, q11)); }
    WHORL_INLINE T clamp(T value) const { return smaller(larger(value, lowest()), highest()); }
};

/// Lanes of neighbouring nodes of one row.
template <class T>
struct Nodes {
    int i, j;
    T x, y;

    WHORL_INLINE Nodes(int first, int row)
        : i(first),
          j(row),
          x(to_values<T>(count_up<IndexLanes<sizeof(T)>>()) + static_cast<Real>(first)),
          y(every<T>(static_cast<Real>(row))) {}
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

    /// Displaced from nodes by d.
    WHORL_INLINE T at(const Nodes<T>& node, Point<T> d) const {
        T x, y;
        const auto i = axis_x.place(node.x, d.x + shift_x, x);
        const auto j = axis_y.place(node.y, d.y + shift_y, y);
        return Cell<T>::around(origin, stride, j * stride + i).bilinear(x, y);
    }
    /// Displaced by the same d, within a cell or two.
    WHORL_INLINE T at(const Nodes<T>& node, Vec2 d) const {
        const Real whole_x = std::floor(d.x + shift_x), whole_y = std::floor(d.y + shift_y);
        const int i = node.i + static_cast<int>(whole_x), j = node.j + static_cast<int>(whole_y);
        if (!axis_x.contains(i, lane_count<T>) || !axis_y.contains(j, 1)) {
            return at(node, Point<T>{every<T>(d.x), every<T>(d.y)});
        }
        return Cell<T>(origin + (static_cast<std::ptrdiff_t>(j) * stride + i), stride)
            .bilinear(every<T>(d.x + shift_x - whole_x), every<T>(d.y + shift_y - whole_y));
    }
};

/// The velocity at points displaced from nodes, as a tracer asks for it.
template <class T, bool periodic>
struct VelocityNear {
    const Component<T, periodic>& u;
    const Component<T, periodic>& v;
    const Nodes<T>& nodes;

    template <class Displacement>
    WHORL_INLINE Point<T> operator()(Displacement d) const {
        return {u.at(nodes, d), v.at(nodes, d)};
    }
};

template <class Tracer, bool periodic>
struct TraceLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Flow& flow, Run nodes, Vec2 start, Real dt, Real* to_x, Real* to_y) {
        using T = RealLanes<bytes>;
        const Component<T, periodic> u(flow.velocity->u, flow.site);
        const Component<T, periodic> v(flow.velocity->v, flow.site);
        for (int k = 0; k < nodes.count; k += lane_count<T>) {
            const Nodes<T> some(nodes.i + k, nodes.j);
            const VelocityNear<T, periodic> velocity{u, v, some};
            const Point<T> d =
                Tracer::trace(velocity, velocity(start), Point<T>{every<T>(start.x), every<T>(start.y)}, dt);
            store(d.x, to_x + k);
            store(d.y, to_y + k);
        }
    }
};

/// The cells of a field that hold points displaced from nodes of a site.
template <class T, bool periodic>
struct Locator {
    Axis<T, periodic> axis_x, axis_y;
    Real shift_x, shift_y;

    WHORL_INLINE Locator(const Field& field, Site site)
        : axis_x(field.width()),
          axis_y(field.height()),
          shift_x(static_cast<Real>(offset_x(site) - offset_x(field.site()))),
          shift_y(static_cast<Real>(offset_y(site) - offset_y(field.site()))) {}

    WHORL_INLINE void place(const Nodes<T>& nodes, Point<T> d, IndexLanes<sizeof(T)>& i,
                            IndexLanes<sizeof(T)>& j, Point<T>& inside) const {
        i = axis_x.place(nodes.x, d.x + shift_x, inside.x);
        j = axis_y.place(nodes.y, d.y + shift_y, inside.y);
    }
};

template <bool periodic>
struct LocateLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& field, Site site, Run nodes, const Real* dx, const Real* dy,
                                 Places& out) {
        using T = RealLanes<bytes>;
        const Locator<T, periodic> locator(field, site);
        const Index stride = field.stride();
        for (int k = 0; k < nodes.count; k += lane_count<T>) {
            IndexLanes<bytes> i, j;
            Point<T> inside;
            locator.place(Nodes<T>(nodes.i + k, nodes.j), {load<T>(dx + k), load<T>(dy + k)}, i, j, inside);
            store(j * stride + i, out.at + k);
            store(i, out.i + k);
            store(j, out.j + k);
            store(inside.x, out.x + k);
            store(inside.y, out.y + k);
        }
    }
};

}  // namespace whorl
