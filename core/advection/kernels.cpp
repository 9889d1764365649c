// The sole place where interpolation, tracer and limiter templates are instantiated.
#include "core/advection/advect.h"

#include <algorithm>
#include <cmath>

namespace whorl {
namespace {

/// Farther than any sensible trace; keeps the whole cells of a wild displacement within an int.
constexpr Real far = 1e6F;

struct AxisPlace {
    int i;
    Real t;
};

/// The interval that holds the point `d` cells from sample `node`, of samples 0 … n − 1.
/// Whole cells and the fraction stay apart, so that precision does not fall with the size of the grid.
template <bool periodic>
inline AxisPlace place(int node, Real d, int n) {
    d = d > -far ? d : -far;  // a NaN goes here too
    d = d < far ? d : far;
    const Real whole = std::floor(d);
    const int i = node + static_cast<int>(whole);
    const Real t = d - whole;
    if constexpr (periodic) {
        const int turns =
            static_cast<int>(std::floor((static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(n)));
        return {i - turns * n, t};
    } else {
        const bool before = i < -1;
        const bool beyond = i > n - 1;
        return {before ? -1 : beyond ? n - 1 : i, before ? Real(0) : beyond ? Real(1) : t};
    }
}

struct Cell {
    Real q00, q10, q01, q11;
};

/// Indices stay integers: a loop over pointers computed from them would not vectorise.
inline Cell cell_at(const Real* origin, int stride, int i, int j) {
    const int at = j * stride + i;
    return {origin[at], origin[at + 1], origin[at + stride], origin[at + stride + 1]};
}

inline Real bilinear(const Cell& q, Real x, Real y) {
    const Real below = Linear::at(q.q00, q.q10, x);
    const Real above = Linear::at(q.q01, q.q11, x);
    return Linear::at(below, above, y);
}

/// One velocity component near the nodes of a site.
template <bool periodic>
struct Component {
    const Real* origin;
    int stride, width, height;
    Real shift_x, shift_y;

    Component(const Field& field, Site node)
        : origin(field.row(0)),
          stride(field.stride()),
          width(field.width()),
          height(field.height()),
          shift_x(static_cast<Real>(offset_x(node) - offset_x(field.site()))),
          shift_y(static_cast<Real>(offset_y(node) - offset_y(field.site()))) {}

    Real at(int i, int j, Vec2 d) const {
        const AxisPlace x = place<periodic>(i, d.x + shift_x, width);
        const AxisPlace y = place<periodic>(j, d.y + shift_y, height);
        return bilinear(cell_at(origin, stride, x.i, y.i), x.t, y.t);
    }
};

template <class Tracer, bool periodic>
struct Trace {
    static WHORL_INLINE void run(const Flow& flow, Run nodes, Vec2 start, Real dt, Displacements& out) {
        const Component<periodic> u(flow.velocity->u, flow.site);
        const Component<periodic> v(flow.velocity->v, flow.site);
        Real* to_x = out.x;
        Real* to_y = out.y;
        WHORL_LANES for (int k = 0; k < nodes.count; ++k) {
            const auto velocity = [&](Vec2 d) {
                return Vec2(u.at(nodes.i + k, nodes.j, d), v.at(nodes.i + k, nodes.j, d));
            };
            const Vec2 d = Tracer::trace(velocity, start, dt);
            to_x[k] = d.x;
            to_y[k] = d.y;
        }
    }
};

template <bool periodic>
struct Locate {
    static WHORL_INLINE void run(const Field& field, Run nodes, const Displacements& d, Places& out) {
        const int width = field.width();
        const int height = field.height();
        Places* to = &out;
        WHORL_LANES for (int k = 0; k < nodes.count; ++k) {
            const AxisPlace x = place<periodic>(nodes.i + k, d.x[k], width);
            const AxisPlace y = place<periodic>(nodes.j, d.y[k], height);
            to->i[k] = x.i;
            to->j[k] = y.i;
            to->x[k] = x.t;
            to->y[k] = y.t;
        }
    }
};

inline Real lowest(const Cell& q) {
    return std::min(std::min(q.q00, q.q10), std::min(q.q01, q.q11));
}
inline Real highest(const Cell& q) {
    return std::max(std::max(q.q00, q.q10), std::max(q.q01, q.q11));
}

/// Four samples along one axis of memory (`step` apart) around sample `at`, interpolated at t.
template <class Interpolation>
inline Real along(const Real* origin, int at, int step, Real t, Interval interval) {
    return Interpolation::at(origin[at - step], origin[at], origin[at + step], origin[at + 2 * step], t,
                             interval);
}

/// One axis first, then the other, over the 4 × 4 samples around a place.
template <class Interpolation, bool x_first>
inline Real cubic(const Real* origin, int stride, int at, Real x, Real y, Interval in_x, Interval in_y) {
    const int step = x_first ? 1 : stride;
    const int across = x_first ? stride : 1;
    const Real t = x_first ? x : y;
    const Interval first = x_first ? in_x : in_y;
    const Real qm = along<Interpolation>(origin, at - across, step, t, first);
    const Real q0 = along<Interpolation>(origin, at, step, t, first);
    const Real q1 = along<Interpolation>(origin, at + across, step, t, first);
    const Real q2 = along<Interpolation>(origin, at + 2 * across, step, t, first);
    return Interpolation::at(qm, q0, q1, q2, x_first ? y : x, x_first ? in_y : in_x);
}

template <class Interpolation, bool x_first, bool clamped, bool periodic>
struct Sample {
    static WHORL_INLINE void run(const Field& field, const Places& at, int count, Values& out) {
        const Real* origin = field.row(0);
        Real* to = out;
        const int stride = field.stride();
        const int last_x = field.width() - 1;
        const int last_y = field.height() - 1;
        WHORL_LANES for (int k = 0; k < count; ++k) {
            if constexpr (Interpolation::support == 2) {
                to[k] = bilinear(cell_at(origin, stride, at.i[k], at.j[k]), at.x[k], at.y[k]);
            } else {
                const Real value = cubic<Interpolation, x_first>(
                    origin, stride, at.j[k] * stride + at.i[k], at.x[k], at.y[k],
                    Interval{at.i[k], last_x, periodic}, Interval{at.j[k], last_y, periodic});
                const Cell cell = cell_at(origin, stride, at.i[k], at.j[k]);
                to[k] = clamped ? std::min(std::max(value, lowest(cell)), highest(cell)) : value;
            }
        }
    }
};

template <Expansion expansion>
struct Share {
    static WHORL_INLINE void run(const Field& field, const Places& at, int count, const Particle& particle,
                                 const Values& at_node, Values& sum) {
        const Real* origin = field.row(0);
        Real* to = sum;
        const Real weight = particle.weight;
        const int stride = field.stride();
        const Real to_x = -particle.offset.x;  // x_i − x_s, cells
        const Real to_y = -particle.offset.y;
        WHORL_LANES for (int k = 0; k < count; ++k) {
            const Cell q = cell_at(origin, stride, at.i[k], at.j[k]);
            Real value = bilinear(q, at.x[k], at.y[k]);
            if constexpr (expansion != Expansion::Value) {
                const Real gradient_x = Linear::at(q.q10 - q.q00, q.q11 - q.q01, at.y[k]);
                const Real gradient_y = Linear::at(q.q01 - q.q00, q.q11 - q.q10, at.x[k]);
                value += gradient_x * to_x + gradient_y * to_y;
            }
            if constexpr (expansion == Expansion::CrossTerm) {
                value += (q.q00 - q.q10 - q.q01 + q.q11) * to_x * to_y;
            }
            to[k] += weight * (value - at_node[k]);
        }
    }
};

template <class Limiter>
struct Limit {
    static WHORL_INLINE void run(const Field& q, const Places& at, int count, const Values& first_order,
                                 Values& value) {
        const Real* origin = q.row(0);
        Real* to = value;
        const int stride = q.stride();
        WHORL_LANES for (int k = 0; k < count; ++k) {
            const Cell cell = cell_at(origin, stride, at.i[k], at.j[k]);
            to[k] = Limiter::limit(to[k], first_order[k], lowest(cell), highest(cell));
        }
    }
};

/// Turns a run-time truth into a template argument.
template <class F>
auto with_bool(bool value, F&& f) {
    return value ? f(std::true_type{}) : f(std::false_type{});
}

SampleFn choose_sample(const SchemeSet& s, bool periodic, Isa isa) {
    return Interpolations::dispatch(s.interpolation, [&]<class I>(std::type_identity<I>) {
        return with_bool(s.axis_order == AxisOrders::of<XFirst>(), [&]<class X>(X) {
            return with_bool(s.clamped, [&]<class C>(C) {
                return with_bool(periodic, [&]<class P>(P) {
                    return PerIsa<SampleFn, Sample<I, X::value, C::value, P::value>>::pick(isa);
                });
            });
        });
    });
}

ShareFn choose_share(Expansion expansion, Isa isa) {
    switch (expansion) {
        case Expansion::Value:
            return PerIsa<ShareFn, Share<Expansion::Value>>::pick(isa);
        case Expansion::Gradient:
            return PerIsa<ShareFn, Share<Expansion::Gradient>>::pick(isa);
        case Expansion::CrossTerm:
            return PerIsa<ShareFn, Share<Expansion::CrossTerm>>::pick(isa);
        case Expansion::None:
            break;
    }
    return nullptr;
}

}  // namespace

Kernels choose_kernels(const SchemeSet& s, bool periodic, Isa isa) {
    Kernels kernels{};
    with_bool(periodic, [&]<class P>(P) {
        kernels.trace = Tracers::dispatch(s.tracer, [&]<class T>(std::type_identity<T>) {
            return PerIsa<TraceFn, Trace<T, P::value>>::pick(isa);
        });
        kernels.locate = PerIsa<LocateFn, Locate<P::value>>::pick(isa);
        kernels.sample_linear = PerIsa<SampleFn, Sample<Linear, true, false, P::value>>::pick(isa);
    });
    kernels.sample = choose_sample(s, periodic, isa);
    kernels.share = choose_share(s.expansion(), isa);
    kernels.limit = Limiters::dispatch(
        s.limiter, [&]<class L>(std::type_identity<L>) { return PerIsa<LimitFn, Limit<L>>::pick(isa); });
    if (Bases::dispatch(s.base, []<class B>(std::type_identity<B>) { return B::clamps_base; })) {
        kernels.limit_base = PerIsa<LimitFn, Limit<ClampLimiter>>::pick(isa);
    }
    return kernels;
}

}  // namespace whorl
