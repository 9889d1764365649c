// The loops of a tracer, made from its formula.
#pragma once

#include <cmath>
#include <concepts>

#include "core/parallel/isa.h"
#include "core/sampling/axis.h"
#include "core/sampling/cell.h"
#include "core/sampling/point.h"
#include "core/tracing/tracer.h"

namespace whorl {

/// One velocity component near the nodes of a site.
template <class T, bool wraps_x, bool wraps_y>
struct Component {
    const Real* origin;
    Index stride;
    Axis<T, wraps_x> axis_x;
    Axis<T, wraps_y> axis_y;
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
        if (!axis_x.contains(i, vector_width<T>) || !axis_y.contains(j, 1)) {
            return at(node, Point<T>{broadcast<T>(d.x), broadcast<T>(d.y)});
        }
        return Cell<T>(origin + (static_cast<std::ptrdiff_t>(j) * stride + i), stride)
            .bilinear(broadcast<T>(d.x + shift_x - whole_x), broadcast<T>(d.y + shift_y - whole_y));
    }
};

/// The velocity at points displaced from nodes, as a tracer asks for it.
template <class T, bool wraps_x, bool wraps_y>
struct VelocityNear {
    const Component<T, wraps_x, wraps_y>& u;
    const Component<T, wraps_x, wraps_y>& v;
    const Nodes<T>& nodes;

    template <class Displacement>
    WHORL_INLINE Point<T> operator()(Displacement d) const {
        return {u.at(nodes, d), v.at(nodes, d)};
    }
};

template <class Scheme, bool wraps_x, bool wraps_y>
struct TraceLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Flow& flow, NodeSpan nodes, Vec2 start, Real dt, Real* to_x,
                                 Real* to_y) {
        using T = RealVector<bytes>;
        const Component<T, wraps_x, wraps_y> u(flow.velocity->u, flow.site);
        const Component<T, wraps_x, wraps_y> v(flow.velocity->v, flow.site);
        for (int k = 0; k < nodes.count; k += vector_width<T>) {
            const Nodes<T> some(nodes.i + k, nodes.j);
            const VelocityNear<T, wraps_x, wraps_y> velocity{u, v, some};
            const Point<T> d = Scheme::trace(velocity, velocity(start),
                                             Point<T>{broadcast<T>(start.x), broadcast<T>(start.y)}, dt);
            store(d.x, to_x + k);
            store(d.y, to_y + k);
        }
    }
};

/// Traces as TraceLoop does, and notes what the tracer asks. Of the vector's elements the first counts.
template <class Scheme, bool wraps_x, bool wraps_y>
TracedPath follow_path(const Flow& flow, int i, int j, Vec2 start, Real dt) {
    using T = RealVector<16>;
    const Component<T, wraps_x, wraps_y> u(flow.velocity->u, flow.site);
    const Component<T, wraps_x, wraps_y> v(flow.velocity->v, flow.site);
    const Nodes<T> node(i, j);
    const VelocityNear<T, wraps_x, wraps_y> velocity{u, v, node};
    TracedPath path;
    const auto first = [](const Point<T>& p) { return Vec2(p.x[0], p.y[0]); };
    const auto noted = [&](const auto& asked, const Point<T>& at) {
        const Point<T> found = velocity(asked);
        path.stages.push_back({first(at), first(found)});
        return found;
    };
    const Point<T> from{broadcast<T>(start.x), broadcast<T>(start.y)};
    const Point<T> k1 = noted(start, from);
    path.start = start;
    path.end = first(Scheme::trace([&](const Point<T>& at) { return noted(at, at); }, k1, from, dt));
    return path;
}

template <class Scheme>
TraceFn choose_trace_loop(Wraps wraps, Isa isa) {
    return with_wraps(wraps, [&]<class X, class Y>(X, Y) {
        return PerIsa<TraceFn, TraceLoop<Scheme, X::value, Y::value>>::pick(isa);
    });
}

template <class Scheme>
TracedPath follow(const Flow& flow, Wraps wraps, int i, int j, Vec2 start, Real dt) {
    return with_wraps(wraps, [&]<class X, class Y>(X, Y) {
        return follow_path<Scheme, X::value, Y::value>(flow, i, j, start, dt);
    });
}

template <class S>
concept TracerScheme = requires(Point<Real> (*u)(Point<Real>), Point<Real> x, Real dt) {
    { S::trace(u, x, x, dt) } -> std::same_as<Point<Real>>;
};

/// The entry of a scheme: `Scheme::info`, and `Scheme::trace(u, k1, x, dt)`: where the flow brings x from,
/// given the velocity u at points, and k1 = u(x); for numbers and for registers of them.
template <TracerScheme Scheme>
constexpr Tracer make_tracer() {
    return {Scheme::info, choose_trace_loop<Scheme>, follow<Scheme>};
}

}  // namespace whorl
