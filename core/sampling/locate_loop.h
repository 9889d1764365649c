// The loop that finds the cells of a field that hold displaced points.
#pragma once

#include "core/sampling/axis.h"
#include "core/sampling/point.h"

namespace whorl {

/// The cells of a field that hold points displaced from nodes of a site.
template <class T, bool wraps_x, bool wraps_y>
struct Locator {
    Axis<T, wraps_x> axis_x;
    Axis<T, wraps_y> axis_y;
    Real shift_x, shift_y;

    WHORL_INLINE Locator(const Field& field, Site site)
        : axis_x(field.width()),
          axis_y(field.height()),
          shift_x(static_cast<Real>(offset_x(site) - offset_x(field.site()))),
          shift_y(static_cast<Real>(offset_y(site) - offset_y(field.site()))) {}

    WHORL_INLINE void place(const Nodes<T>& nodes, Point<T> d, IndexVector<sizeof(T)>& i,
                            IndexVector<sizeof(T)>& j, Point<T>& inside) const {
        i = axis_x.place(nodes.x, d.x + shift_x, inside.x);
        j = axis_y.place(nodes.y, d.y + shift_y, inside.y);
    }
};

template <bool wraps_x, bool wraps_y>
struct LocateLoop {
    template <int bytes>
    static WHORL_INLINE void run(const Field& field, Site site, NodeSpan nodes, const Real* dx,
                                 const Real* dy, CellPositions& out) {
        using T = RealVector<bytes>;
        const Locator<T, wraps_x, wraps_y> locator(field, site);
        const Index stride = field.stride();
        for (int k = 0; k < nodes.count; k += vector_width<T>) {
            IndexVector<bytes> i, j;
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
