#include "core/inspect/paths.h"

#include <cmath>

#include "core/advection/advect.h"
#include "core/advection/tracing_loops.h"

namespace whorl {
namespace {

constexpr int fine_steps = 64;

WorldPoint world(const Departing& from, double x, double y) {
    const double h = from.boundary->grid().h;
    return {(from.i + offset_x(from.site) + x) * h, (from.j + offset_y(from.site) + y) * h};
}

/// Traces as TraceLoop does, and notes what the tracer asks. Of the lanes the first counts.
template <class Tracer, bool periodic>
Path trace(const Departing& from) {
    using T = RealLanes<16>;
    const auto first = [](T lanes) { return static_cast<double>(lanes[0]); };
    const Component<T, periodic> u(from.velocity->u, from.site);
    const Component<T, periodic> v(from.velocity->v, from.site);
    const Nodes<T> node(from.i, from.j);
    const VelocityNear<T, periodic> velocity{u, v, node};
    const Point<T> start{every<T>(from.start.x), every<T>(from.start.y)};
    Path path;
    const auto note = [&](const Point<T>& at, const Point<T>& found) {
        path.stages.push_back({world(from, first(at.x), first(at.y)), first(found.x), first(found.y)});
    };
    const auto noted = [&](const Point<T>& at) {
        const Point<T> found = velocity(at);
        note(at, found);
        return found;
    };
    const Point<T> k1 = velocity(from.start);
    note(start, k1);
    const Point<T> end = Tracer::trace(noted, k1, start, from.dt);
    path.start = world(from, first(start.x), first(start.y));
    path.end = world(from, first(end.x), first(end.y));
    return path;
}

}  // namespace

Path path_of(Tracers::Id tracer, const Departing& from) {
    return Tracers::dispatch(tracer, [&]<class Tracer>(std::type_identity<Tracer>) {
        return from.boundary->periodic() ? trace<Tracer, true>(from) : trace<Tracer, false>(from);
    });
}

std::vector<WorldPoint> fine_path(const Departing& from) {
    SchemeSet schemes;
    schemes.tracer = Tracers::of<Rk4>();
    const TraceFn trace = choose_kernels(schemes, from.boundary->periodic()).trace;
    std::vector<WorldPoint> points;
    Vec2 at = from.start;
    const auto sensible = [](Real d) { return std::abs(d) < far; };
    for (int k = 0; k <= fine_steps && sensible(at.x) && sensible(at.y); ++k) {
        points.push_back(world(from, static_cast<double>(at.x), static_cast<double>(at.y)));
        Displacements d{};
        trace({from.velocity, from.site}, {from.i, from.j, 1}, at, from.dt / fine_steps, d.x, d.y);
        at = Vec2(d.x[0], d.y[0]);
    }
    return points;
}

}  // namespace whorl
